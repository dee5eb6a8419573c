// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/partition_builder.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kTrianglesPerTask = 8192;

void include(PlanBox& box, const PlanBox& other) {
  for (int axis = 0; axis < 2; ++axis) {
    box.lower[axis] = std::min(box.lower[axis], other.lower[axis]);
    box.upper[axis] = std::max(box.upper[axis], other.upper[axis]);
  }
}

class Numbering {
 public:
  explicit Numbering(Partition& partition) : partition_(partition) {}

  Index visit(const CutTree& tree, const CellBounds& bounds) {
    if (!tree.below) {
      partition_.cells.push_back({.bounds = bounds});
      return -static_cast<Index>(partition_.cells.size());
    }
    const auto node = static_cast<Index>(partition_.nodes.size());
    partition_.nodes.push_back({.axis = tree.axis, .coordinate = tree.coordinate});
    if (tree.axis < 2) partition_.borders[tree.axis].push_back(tree.coordinate);
    CellBounds part = bounds;
    part.upper[tree.axis] = tree.coordinate;
    const Index below = visit(*tree.below, part);
    part = bounds;
    part.lower[tree.axis] = tree.coordinate;
    const Index above = visit(*tree.above, part);
    partition_.nodes[node].below = below;
    partition_.nodes[node].above = above;
    return node;
  }

  void finish() {
    for (auto& borders : partition_.borders) {
      sortOnce(borders);
    }
    for (Cell& cell : partition_.cells)
      for (int axis = 0; axis < 2; ++axis) {
        cell.bounds.lowerBorder[axis] = numberOf(axis, cell.bounds.lower[axis]);
        cell.bounds.upperBorder[axis] = numberOf(axis, cell.bounds.upper[axis]);
      }
  }

 private:
  [[nodiscard]] Index numberOf(int axis, double coordinate) const {
    const auto& borders = partition_.borders[axis];
    const auto found = std::lower_bound(borders.begin(), borders.end(), coordinate);
    return found == borders.end() || *found != coordinate ? -1 : static_cast<Index>(found - borders.begin());
  }

  Partition& partition_;
};

}  // namespace

PlanBox planBoxOf(const SourceMesh& mesh, Index triangle) {
  const auto& f = mesh.triangles[triangle];
  const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
}

PlanBox planBoxOf(const StrategyInput& input) {
  return parallelReduce(
      input.mesh.triangles.size(), kTrianglesPerTask, PlanBox{},
      [&](const auto& range, PlanBox box) {
        input.poll();
        for (std::size_t t = range.begin(); t < range.end(); ++t)
          if (input.removed[t] == 0) include(box, planBoxOf(input.mesh, static_cast<Index>(t)));
        return box;
      },
      [](PlanBox box, const PlanBox& other) {
        include(box, other);
        return box;
      });
}

void CellLimit::add(std::int64_t cells) {
  if (cells_.fetch_add(cells) + cells <= kMostCells) return;
  throw InputError(FOOTFALL_TEXT("%1 would make more than %2 cells; %3"), strategy_, kMostCells, advice_);
}

Partition partitionOf(const CutTree& tree) {
  Partition partition;
  Numbering numbering(partition);
  numbering.visit(tree, {});
  numbering.finish();
  return partition;
}

}  // namespace footfall::detail
