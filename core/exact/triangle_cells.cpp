// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/triangle_cells.hpp"

namespace footfall::detail {

void TriangleCells::start(const std::array<Index, 3>& corners) {
  cells_.assign(1, {corners, {~corners[0], ~corners[1], ~corners[2]}});
  cellOf_.assign(3, 0);
}

void TriangleCells::splitCell(Index cell, Index point) {
  const TriangleCell old = cells_[cell];
  const auto second = static_cast<Index>(cells_.size()), third = second + 1;
  const auto& [a, b, c] = old.corners;
  const auto& [ab, bc, ca] = old.neighbors;
  cells_[cell] = {{a, b, point}, {ab, second, third}};
  cells_.push_back({{b, c, point}, {bc, third, cell}});
  cells_.push_back({{c, a, point}, {ca, cell, second}});
  replaceNeighbor(bc, cell, second);
  replaceNeighbor(ca, cell, third);
  cellOf_[a] = cellOf_[point] = cell;
  cellOf_[b] = second;
  cellOf_[c] = third;
}

Index TriangleCells::splitHalf(Index cell, int k, Index point) {
  const TriangleCell old = cells_[cell];
  const auto second = static_cast<Index>(cells_.size());
  const Index a = old.corners[k], b = old.corners[next(k)], c = old.corners[previous(k)];
  const Index bc = old.neighbors[next(k)], ca = old.neighbors[previous(k)];
  cells_[cell] = {{a, point, c}, {old.neighbors[k], second, ca}};
  cells_.push_back({{point, b, c}, {old.neighbors[k], bc, cell}});
  replaceNeighbor(bc, cell, second);
  cellOf_[a] = cellOf_[c] = cellOf_[point] = cell;
  cellOf_[b] = second;
  return second;
}

void TriangleCells::splitEdge(Index cell, int k, Index point) {
  const Index other = cells_[cell].neighbors[k];
  const int j = other >= 0 ? neighborSlot(cells_[other], cell) : 0;
  const Index cellEnd = splitHalf(cell, k, point);
  if (other < 0) return;
  const Index otherEnd = splitHalf(other, j, point);
  // both halves were split from their own start, which is the other one's end
  cells_[cell].neighbors[0] = otherEnd;
  cells_[otherEnd].neighbors[0] = cell;
  cells_[cellEnd].neighbors[0] = other;
  cells_[other].neighbors[0] = cellEnd;
}

}  // namespace footfall::detail
