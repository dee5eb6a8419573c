// The division of an environment into cells: a tree of cuts, in the plan and between heights
// (docs/explanation/model.md; thesis 4.3).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "footfall/statistics.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

struct Cell {
  CellBounds bounds;
  double cost = 0;              ///< estimated work, in units of one trivial triangle
  std::uint64_t floors = 0;     ///< walkable triangles, or pieces of them, in the cell
  std::uint64_t obstacles = 0;  ///< triangles, walkable or rejected, that may matter to those floors
};

/// Every border is one double, computed once: cells on both sides mean the same line.
struct Partition {
  /// A cut: what is below the coordinate, and what is at it or above. A child c >= 0 is a node, else the cell -1 - c.
  struct Node {
    int axis = 0;  ///< 0 and 1: a border in the plan; 2: a height
    double coordinate = 0;
    Index below = -1;
    Index above = -1;
  };
  std::array<std::vector<double>, 2> borders;  ///< distinct and ascending, in x and in y
  std::vector<Node> nodes;                     ///< the first is the root; empty: one cell
  std::vector<Cell> cells;                     ///< at least one cell
  std::string strategy;                        ///< the strategy that made the cells, with its parameters
  Text reason;                                 ///< why, where a strategy had the choice; else empty

  /// Calls `visit(cell)` for every cell that a floor whose lowest corner is at `z` can have a part in: the cells that
  /// its box in the plan overlaps with an area; for a box without width, those that hold it (half-open).
  template <class Visit>
  void visitCells(const std::array<double, 2>& lower, const std::array<double, 2>& upper, double z,
                  const Visit& visit) const {
    if (nodes.empty()) {
      visit(Index{0});
      return;
    }
    visitNode(0, lower, upper, z, z, visit);
  }
  /// The same for heights from `zLower` to `zUpper`, both included.
  template <class Visit>
  void visitCells(const std::array<double, 2>& lower, const std::array<double, 2>& upper, double zLower, double zUpper,
                  const Visit& visit) const {
    if (nodes.empty()) {
      visit(Index{0});
      return;
    }
    visitNode(0, lower, upper, zLower, zUpper, visit);
  }

 private:
  template <class Visit>
  void visitNode(Index child, const std::array<double, 2>& lower, const std::array<double, 2>& upper, double zLower,
                 double zUpper, const Visit& visit) const {
    if (child < 0) {
      visit(-1 - child);
      return;
    }
    const Node& node = nodes[child];
    const double c = node.coordinate;
    const double low = node.axis == 2 ? zLower : lower[node.axis];
    const double high = node.axis == 2 ? zUpper : upper[node.axis];
    const bool reachesAbove = node.axis == 2 ? high >= c : high > c || low >= c;
    if (low < c) visitNode(node.below, lower, upper, zLower, zUpper, visit);
    if (reachesAbove) visitNode(node.above, lower, upper, zLower, zUpper, visit);
  }
};

}  // namespace footfall::detail
