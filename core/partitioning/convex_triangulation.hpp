// Triangulates convex polygons that have further points on their sides, by what the points are and not by where they
// lie: no triangle is degenerate.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/exact/source_mesh.hpp"

namespace footfall::detail {

/// Triangulates one convex polygon after another, on one thread.
///
/// Corners are cut off one by one, those first that make the shortest new side (rounded places only choose between
/// right ways). When a corner goes, its neighbours become corners if they were points on a side, as the new side leaves
/// that side's line; and stay corners if they were, unless all others lie on one line. So what is a corner needs no
/// computing, and the one case to avoid is a triangle with points on just one side, which is a fan from the corner
/// opposite.
class ConvexTriangulation {
 public:
  /// `places` may grow, but not go, while this is used.
  explicit ConvexTriangulation(const std::vector<Vec3>& places) : places_(places) {}

  void start() { outline_.clear(); }
  void addCorner(Index vertex) { outline_.push_back({vertex, true}); }
  /// A point on the side behind the last corner.
  void addPoint(Index vertex) { outline_.push_back({vertex, false}); }
  /// Calls `add(corners)` for each triangle, turned as the outline is.
  template <class Add>
  void finish(const Add& add) {
    while (outline_.size() > 3) {
      if (const std::size_t apex = fanApex(); apex < outline_.size()) {
        for (std::size_t k = 1; k + 1 < outline_.size(); ++k)
          add({outline_[apex].vertex, outline_[turned(apex, k)].vertex, outline_[turned(apex, k + 1)].vertex});
        return;
      }
      const std::size_t k = bestCorner(), before = turned(k, outline_.size() - 1), after = turned(k, 1);
      add({outline_[before].vertex, outline_[k].vertex, outline_[after].vertex});
      outline_[before].isCorner = outline_[after].isCorner = true;
      outline_.erase(outline_.begin() + static_cast<std::ptrdiff_t>(k));
    }
    add({outline_[0].vertex, outline_[1].vertex, outline_[2].vertex});
  }

 private:
  struct OutlinePoint {
    Index vertex;
    bool isCorner;
  };
  [[nodiscard]] std::size_t turned(std::size_t k, std::size_t by) const { return (k + by) % outline_.size(); }
  /// The corner of a triangle opposite to the one side that has points; else the number of points.
  [[nodiscard]] std::size_t fanApex() const;
  [[nodiscard]] std::size_t bestCorner() const;

  const std::vector<Vec3>& places_;
  std::vector<OutlinePoint> outline_;
};

}  // namespace footfall::detail
