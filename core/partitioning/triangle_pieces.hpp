// Triangles and what cuts leave of them, as the recursive strategies count them (thesis 4.3.2, 4.3.3).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only a count that chooses where to cut: rounded coordinates are good enough, and always finite.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/partitioning/partition_builder.hpp"

namespace footfall::detail {

/// The pieces of triangles in one node of the tree of cuts.
class TrianglePieces {
 public:
  /// All triangles that are not removed.
  explicit TrianglePieces(const StrategyInput& input);

  [[nodiscard]] std::size_t size() const { return whole_.size() + parts_.size(); }
  /// The largest coordinates of the pieces, in any order.
  [[nodiscard]] std::vector<double> ends(int axis) const;
  /// Divides the pieces at a border; none are left here. A piece that lies on the border and nowhere above it is below:
  /// 4.3.3 places the border at the largest coordinate of the middle triangle, so that this triangle is on the negative
  /// side, and so does the text on flags in 4.3.1. Algorithm 1 flags such a piece as positive. Cells differ from this
  /// count, as they are half-open (cutting.hpp); only the balance depends on it, never a result.
  [[nodiscard]] std::array<TrianglePieces, 2> split(int axis, double coordinate, const StrategyInput& input);

  using Point = std::array<double, 2>;

 private:
  /// A remainder of a cut triangle, a convex outline.
  struct Part {
    PlanBox box;
    Index firstCorner = 0;  ///< index in corners_
    Index cornerCount = 0;
  };

  TrianglePieces() = default;
  void addPart(std::span<const Point> outline);

  std::shared_ptr<const std::vector<PlanBox>> boxes_;  ///< boxes of all triangles
  std::vector<Index> whole_;                           ///< triangles that no cut has met
  std::vector<Part> parts_;
  std::vector<Point> corners_;
};

/// Cuts a node, whose pieces lie in `box`, and calls grow(tree, pieces, box) for either side: at the same time where
/// there are many pieces.
template <class Grow>
void cutInTwo(CutTree& tree, TrianglePieces pieces, const PlanBox& box, int axis, double coordinate,
              const StrategyInput& input, const Grow& grow) {
  constexpr std::size_t kParallelSize = 2048;  // fewer pieces are not worth a second thread
  tree.axis = axis;
  tree.coordinate = coordinate;
  tree.below = std::make_unique<CutTree>();
  tree.above = std::make_unique<CutTree>();
  const bool isLarge = pieces.size() >= kParallelSize;
  auto parts = pieces.split(axis, coordinate, input);
  PlanBox lower = box, upper = box;
  lower.upper[axis] = upper.lower[axis] = coordinate;
  const auto below = [&] { grow(*tree.below, std::move(parts[0]), lower); };
  const auto above = [&] { grow(*tree.above, std::move(parts[1]), upper); };
  if (isLarge)
    parallelInvoke(below, above);
  else
    below(), above();
}

}  // namespace footfall::detail
