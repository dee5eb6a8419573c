// RecursiveStrategy: a quad tree of rectangles that are cut in the middle (thesis 4.3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include "core/partitioning/partition_builder.hpp"
#include "core/partitioning/triangle_pieces.hpp"

namespace footfall::detail {
namespace {

class QuadTree {
 public:
  QuadTree(const RecursionLimits& limits, const std::string& name, const StrategyInput& input)
      : limits_(limits), input_(input), cellLimit_(name, RecursionLimits::kAdvice) {}

  void grow(CutTree& tree, TrianglePieces pieces, const PlanBox& box, int depth) {
    if (depth >= limits_.depth || static_cast<double>(pieces.size()) <= limits_.triangles) return;
    const Middle middle{std::midpoint(box.lower[0], box.upper[0]), std::midpoint(box.lower[1], box.upper[1])};
    cut(tree, std::move(pieces), box, middle, 1, depth);
  }

 private:
  using Middle = std::array<double, 2>;

  // First across y, then both halves across x; an axis on which the rectangle has no double in between is left out.
  void cut(CutTree& tree, TrianglePieces pieces, const PlanBox& box, const Middle& middle, int axis, int depth) {
    if (axis < 0) return grow(tree, std::move(pieces), box, depth + 1);
    if (!box.isInside(axis, middle[axis])) {
      // Both axes have no width, so further cuts would change nothing.
      if (axis == 1 && !box.isInside(0, middle[0])) return;
      return cut(tree, std::move(pieces), box, middle, axis - 1, depth);
    }
    cellLimit_.add(1);
    cutInTwo(tree, std::move(pieces), box, axis, middle[axis], input_,
             [&](CutTree& half, TrianglePieces part, const PlanBox& halfBox) {
               cut(half, std::move(part), halfBox, middle, axis - 1, depth);
             });
  }

  const RecursionLimits& limits_;
  const StrategyInput& input_;
  CellLimit cellLimit_;
};

}  // namespace

std::unique_ptr<CutTree> growRecursive(const RecursionLimits& limits, const std::string& name,
                                       const StrategyInput& input) {
  auto tree = std::make_unique<CutTree>();
  const PlanBox box = planBoxOf(input);
  if (!box.empty()) QuadTree(limits, name, input).grow(*tree, TrianglePieces(input), box, 0);
  return tree;
}

}  // namespace footfall::detail
