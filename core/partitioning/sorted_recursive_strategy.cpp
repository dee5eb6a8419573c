// SortedRecursiveStrategy: halves of equally many triangles, across x and y in turn (thesis 4.3.3).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/partitioning/partition_builder.hpp"
#include "core/partitioning/triangle_pieces.hpp"

namespace footfall::detail {
namespace {

class SortedTree {
 public:
  SortedTree(const RecursionLimits& limits, const std::string& name, const StrategyInput& input)
      : limits_(limits), input_(input), cellLimit_(name, RecursionLimits::kAdvice) {}

  void grow(CutTree& tree, TrianglePieces pieces, const PlanBox& box, int depth) {
    if (depth >= limits_.depth || static_cast<double>(pieces.size()) <= limits_.triangles) return;
    const int axis = depth % 2;
    input_.poll();
    // The largest coordinate of element n/2 in order of the largest coordinates.
    std::vector<double> ends = pieces.ends(axis);
    const auto middle = ends.begin() + static_cast<std::ptrdiff_t>(ends.size() / 2);
    std::nth_element(ends.begin(), middle, ends.end());
    const double cut = *middle;
    // The thesis stops where a side would be empty: above, when nothing reaches beyond the cut; below, when what ends
    // there has no width.
    if (*std::max_element(middle, ends.end()) <= cut || !box.isInside(axis, cut)) return;
    ends = {};
    cellLimit_.add(1);
    cutInTwo(tree, std::move(pieces), box, axis, cut, input_,
             [&](CutTree& half, TrianglePieces part, const PlanBox& halfBox) {
               grow(half, std::move(part), halfBox, depth + 1);
             });
  }

 private:
  const RecursionLimits& limits_;
  const StrategyInput& input_;
  CellLimit cellLimit_;
};

}  // namespace

std::unique_ptr<CutTree> growSortedRecursive(const RecursionLimits& limits, const std::string& name,
                                             const StrategyInput& input) {
  auto tree = std::make_unique<CutTree>();
  const PlanBox box = planBoxOf(input);
  if (!box.empty()) SortedTree(limits, name, input).grow(*tree, TrianglePieces(input), box, 0);
  return tree;
}

}  // namespace footfall::detail
