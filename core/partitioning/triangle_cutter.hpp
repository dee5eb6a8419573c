// Cuts one triangle along the borders of the cells that it has a part in, into convex polygons.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/partitioning/cut_vertex.hpp"

namespace footfall::detail {

/// The line on which a side of a piece lies: the border `number` of axis 0 or 1, or (axis 2) the triangle's edge from
/// corner `number` to the next one.
struct PieceSide {
  static constexpr int kEdge = 2;
  Index axis = kEdge;
  Index number = -1;
};

struct PieceCorner {
  CutVertex vertex;
  PieceSide side;  ///< side to the next corner
};

/// Pieces of triangles, one behind the other: strictly convex, turning as their triangle does.
struct CutPieces {
  struct Piece {
    std::size_t first = 0;  ///< index in corners
    std::size_t count = 0;
    Index cell = -1;
  };
  std::vector<PieceCorner> corners;
  std::vector<Piece> pieces;
};

class TriangleCutter {
 public:
  TriangleCutter(const CutGeometry& geometry, const Partition& partition);

  /// The child (as in Partition::Node) at which a triangle's box is first divided: a node, or the cell that holds it.
  /// Degenerate triangles are never divided: they go where their first corner is.
  [[nodiscard]] Index descend(Index triangle) const;

  /// Appends the pieces of a triangle from a node on, below each cut before above it.
  void cut(Index triangle, Index node, CutPieces& pieces) const;

 private:
  /// A triangle inside a rectangle has at most seven corners; while it is cut, one more.
  struct Polygon {
    std::array<PieceCorner, 10> corners;
    std::size_t size = 0;
    void push(const CutVertex& vertex, const PieceSide& side) { corners[size++] = {vertex, side}; }
  };
  void cut(Index triangle, const Polygon& whole, Index child, double z, CutPieces& pieces) const;
  /// The crossing of a side with the border.
  [[nodiscard]] CutVertex crossing(Index triangle, const PieceSide& side, const PieceSide& border) const;

  const CutGeometry& geometry_;
  const Partition& partition_;
  std::vector<Index> borderOfNode_;
};

}  // namespace footfall::detail
