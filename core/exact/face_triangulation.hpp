// A constrained triangulation of one floor triangle by the segments that obstacles leave on it.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Incremental: points are located by walking, segments are inserted by flipping edges away, and where two segments
// cross their canonical crossing point becomes a vertex. All decisions are exact. That the triangles are well shaped
// (nearly Delaunay) is a nicety and is judged by rounded coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/face_geometry.hpp"

namespace footfall::detail {

class FaceTriangulation {
 public:
  /// A triangle; edge k runs from corner k to corner k + 1.
  struct Cell {
    std::array<Index, 3> corners{};
    std::array<Index, 3> neighbors{-1, -1, -1};  ///< -1 outside the face
    std::array<Index, 3> lines{-1, -1, -1};      ///< supporting line of a constrained edge, else -1
    std::array<int, 3> windings{};               ///< change of the winding number when the edge is entered from outside
    std::array<std::uint8_t, 3> walls{};
  };

  /// `poll` is called now and then and may throw to cancel.
  FaceTriangulation(FaceGeometry& geometry, Poll poll) : geometry_(geometry), poll_(poll) {}

  /// Starts with the face of the geometry as the only cell.
  void start();
  /// Inserts a point of the geometry that lies in the closed face; returns the vertex at its position (another point
  /// when one is there already).
  Index insertPoint(Index point);
  /// Inserts the segment from vertex u to vertex v on `line`; `direction` is +1 when u to v runs along the line.
  /// `winding` is added on its left side.
  void insertSegment(Index u, Index v, Index line, int direction, int winding, bool wall);
  /// Marks the face's edge k (corner k to k + 1) as a wall. To be called right after start().
  void markEdgeWall(int k);
  /// Drops constraints without effect.
  void dropConstraints();
  /// Flips edges towards Delaunay between cells that are wanted (for each cell); a flip keeps both winding numbers.
  void improve(const std::vector<char>& isWanted);

  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  /// The cell beside the start of the face's edge from corner 0 to 1.
  [[nodiscard]] Index startCell() const;
  /// Winding number of each cell: how many regions cover it. `start`: that of startCell().
  [[nodiscard]] std::vector<int> windingNumbers(int start) const;

 private:
  using Edge = std::array<Index, 2>;

  void growTables();
  void replaceNeighbor(Index cell, Index from, Index to);
  static void copyEdge(Cell& to, int i, const Cell& from, int j);
  void splitCell(Index cell, Index point);
  void splitEdge(Index cell, int k, Index point);
  Index splitHalf(Index cell, int k, Index point);
  void flip(Index cell, int k);
  bool flipIfBetter(Index cell, int k);
  void legalize();
  Index locate(Index point, int& zeros, int& k);
  bool findEdge(Index a, Index b, Index& cell, int& k) const;
  /// False when there is no such edge.
  bool markEdge(Index a, Index b, Index line, int winding, bool wall);
  int sideOfSegment(Index line, int direction, Index vertex);
  /// One step of insertSegment: from u to the next vertex on the segment, making edge u-next.
  Index advance(Index u, Index line, int direction);
  /// Flips the edges in crossed_ away from the segment.
  void flipAway(Index line, int direction);
  void poll();

  FaceGeometry& geometry_;
  Poll poll_;
  std::vector<Cell> cells_;
  std::vector<Index> cellOf_;          ///< a cell at each vertex
  std::vector<Index> representative_;  ///< -1: not inserted
  std::vector<Index> sideStamp_;
  std::vector<std::int8_t> sideValue_;
  Index stamp_ = 0;
  Index hint_ = 0;
  std::uint32_t random_ = 1;
  std::uint32_t polls_ = 0;
  std::vector<std::array<Index, 2>> stack_;  ///< (cell, new vertex) to legalize
  // Working memory, kept for the next face.
  std::vector<Edge> crossed_;     ///< edges that a segment crosses
  std::vector<Index> unsettled_;  ///< cells that improve() has to look at
  std::vector<char> isUnsettled_;
};

}  // namespace footfall::detail
