// GridStrategy: a grid of equal rectangles (thesis 4.3.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/partitioning/partition_builder.hpp"

namespace footfall::detail {
namespace {

// The cuts lie at the thesis's lower + (width / count) * i. Two ends so far apart that the width overflows are halved
// first. Cuts that rounding brings together, or onto an end, are one or none.
std::vector<double> equalCuts(double lower, double upper, int count) {
  std::vector<double> cuts;
  const double scale = std::isfinite(upper - lower) ? 1 : 0.5;
  const double step = (upper * scale - lower * scale) / count;
  double last = lower;
  for (int i = 1; i < count; ++i) {
    const double cut = (lower * scale + step * i) / scale;
    if (!(last < cut && cut < upper)) continue;
    cuts.push_back(cut);
    last = cut;
  }
  return cuts;
}

using Cuts = std::array<std::span<const double>, 2>;

// Cuts across the longer list in its middle, so that a point passes few nodes on its way to its cell.
std::unique_ptr<CutTree> balancedTree(const Cuts& cuts) {
  auto tree = std::make_unique<CutTree>();
  const int axis = cuts[1].size() > cuts[0].size() ? 1 : 0;
  if (cuts[axis].empty()) return tree;
  const std::size_t middle = cuts[axis].size() / 2;
  tree->axis = axis;
  tree->coordinate = cuts[axis][middle];
  Cuts part = cuts;
  part[axis] = cuts[axis].first(middle);
  tree->below = balancedTree(part);
  part[axis] = cuts[axis].subspan(middle + 1);
  tree->above = balancedTree(part);
  return tree;
}

}  // namespace

std::unique_ptr<CutTree> growGrid(double columns, double rows, const std::string& name, const StrategyInput& input) {
  // Checked as doubles, before anything is counted in integers or allocated.
  CellLimit limit(name, FOOTFALL_TEXT("give fewer columns or rows"));
  limit.add(columns * rows > CellLimit::kMostCells ? CellLimit::kMostCells : 0);
  const PlanBox box = planBoxOf(input);
  if (box.empty()) return std::make_unique<CutTree>();
  const std::vector<double> x = equalCuts(box.lower[0], box.upper[0], static_cast<int>(columns));
  const std::vector<double> y = equalCuts(box.lower[1], box.upper[1], static_cast<int>(rows));
  return balancedTree({x, y});
}

}  // namespace footfall::detail
