// Triangles and what cuts leave of them, as the recursive strategies count them (thesis 4.3.2, 4.3.3).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only a count that chooses where to cut: rounded coordinates are good enough, and always finite.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/partitioning/partition_builder.hpp"

namespace footfall::detail {

/// What lies in one node of the tree of cuts.
class TrianglePieces {
 public:
  /// All triangles that are not removed.
  explicit TrianglePieces(const StrategyInput& input);

  [[nodiscard]] std::size_t size() const { return whole_.size() + parts_.size(); }
  /// The largest coordinates of the pieces, in any order.
  [[nodiscard]] std::vector<double> ends(int axis) const;
  /// Divides the pieces at a border; none are left here. As in the thesis, what lies on the border and nowhere above it
  /// is below.
  [[nodiscard]] std::array<TrianglePieces, 2> split(int axis, double coordinate, const StrategyInput& input);

  using Point = std::array<double, 2>;

 private:
  /// What cuts left of a triangle, a convex outline.
  struct Part {
    PlanBox box;
    Index firstCorner = 0;  ///< in corners_
    Index cornerCount = 0;
  };

  TrianglePieces() = default;
  void addPart(std::span<const Point> outline);

  std::shared_ptr<const std::vector<PlanBox>> boxes_;  ///< of all triangles
  std::vector<Index> whole_;                           ///< triangles that no cut has met
  std::vector<Part> parts_;
  std::vector<Point> corners_;
};

}  // namespace footfall::detail
