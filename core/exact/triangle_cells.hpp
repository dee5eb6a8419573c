// Triangles that share edges and vertices: splitting them, and flipping their edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/geometry.hpp"

namespace footfall::detail {

/// A triangle; edge k runs from corner k to corner k + 1.
struct TriangleCell {
  std::array<Index, 3> corners{};
  std::array<Index, 3> neighbors{};  ///< beyond the first cell's edges negative: ~v, v being where such an edge starts
};

inline int cornerOf(const TriangleCell& cell, Index vertex) {
  return cell.corners[0] == vertex ? 0 : cell.corners[1] == vertex ? 1 : 2;
}

inline int neighborSlot(const TriangleCell& cell, Index neighbor) {
  return cell.neighbors[0] == neighbor ? 0 : cell.neighbors[1] == neighbor ? 1 : 2;
}

/// Cells that tile the first one. Small, since triangulating is mostly flipping: what else is known of edges lies
/// elsewhere (FaceTriangulation).
class TriangleCells {
 public:
  /// Makes the first cell the only one. Its corners are the vertices 0, 1, 2 in some order.
  void start(const std::array<Index, 3>& corners);
  /// Makes room for vertices with numbers below `count`.
  void growVertices(std::size_t count) {
    if (cellOf_.size() < count) cellOf_.resize(count, -1);
  }

  [[nodiscard]] const std::vector<TriangleCell>& all() const { return cells_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  const TriangleCell& operator[](Index cell) const { return cells_[cell]; }
  /// A cell at a vertex.
  [[nodiscard]] Index cellOf(Index vertex) const { return cellOf_[vertex]; }

  /// Splits a cell at a point inside, which becomes corner 2 of all parts; part i has the edge i of the cell. Part 0
  /// takes the place of the cell, the others are new.
  void splitCell(Index cell, Index point);
  /// Splits a cell and its neighbor at a point on edge k. Either cell keeps the part at its edge's start (the point is
  /// corner 1); the parts at the ends are new, that of the cell first (the point is corner 0).
  void splitEdge(Index cell, int k, Index point);
  /// Flips edge k of a cell, which has a neighbor there. Edge 1 of the cell and edge 2 of the neighbor are the new one;
  /// edge 0 of both was the neighbor's, the others the cell's.
  void flip(Index cell, int k) {
    TriangleCell& x = cells_[cell];
    const Index other = x.neighbors[k];
    TriangleCell& y = cells_[other];
    const int j = neighborSlot(y, cell), beforeK = previous(k), afterK = next(k), beforeJ = previous(j);
    const Index a = x.corners[k], b = x.corners[afterK], c = x.corners[beforeK], d = y.corners[beforeJ];
    const Index ad = y.neighbors[next(j)], db = y.neighbors[beforeJ], bc = x.neighbors[afterK],
                ca = x.neighbors[beforeK];
    x = {{a, d, c}, {ad, other, ca}};
    y = {{d, b, c}, {db, bc, cell}};
    replaceNeighbor(ad, other, cell);
    replaceNeighbor(bc, cell, other);
    cellOf_[c] = cellOf_[a] = cellOf_[d] = cell;
    cellOf_[b] = other;
  }

 private:
  void replaceNeighbor(Index cell, Index from, Index to) {
    if (cell >= 0) cells_[cell].neighbors[neighborSlot(cells_[cell], from)] = to;
  }
  Index splitHalf(Index cell, int k, Index point);

  std::vector<TriangleCell> cells_;
  std::vector<Index> cellOf_;
};

}  // namespace footfall::detail
