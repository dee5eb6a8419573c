// Needles whose corners rounding moved onto, or beyond, their edges: edges that pass near a vertex lead through it.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several needles between lines that nearly coincide may turn each other's corners over, so that no single edge can be
// turned or taken away. Then all edges about them are snapped at once: each that passes a vertex within `reach` is
// divided there, on both of its sides, and each triangle becomes the polygon with these vertices on its edges (J. D.
// Hobby, "Practical segment intersection with finite precision output", 1999, whose hot pixels are discs here). Of a
// needle nothing is left, as its outline runs back where it came from; others are triangulated. No vertex moves, and
// each edge becomes a chain whose vertices are within `reach` of it, one behind the other, so that chain and edge are
// nowhere farther from each other than that.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/filters/rounding/repaired_mesh.hpp"

namespace footfall::detail {

class NeedleSnapper {
 public:
  explicit NeedleSnapper(RepairedMesh& mesh) : mesh_(mesh) {}

  enum class Outcome { Done, Failed, NeedsOnePlace };
  /// Snaps what is about a triangle that does not face up. All triangles that come of it do. Nothing changes where that
  /// fails, or where vertices within `reach` of each other must become one before: together().
  Outcome snap(Index broken, double reach);
  /// Two vertices, the smaller one first.
  [[nodiscard]] const std::array<Index, 2>& together() const { return together_.front(); }

 private:
  using Edge = std::array<Index, 2>;  ///< the smaller vertex first
  static Edge edgeOf(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }
  /// A piece of a triangle's outline, from its first vertex to that of the next piece.
  struct Piece {
    Index from = -1;
    bool isObstacle = false;
  };
  using Outline = std::vector<Piece>;
  struct NewTriangle {
    Index from = -1;  ///< the triangle that it is a part of
    MeshTriangle triangle;
  };

  /// The place of a vertex along an edge, as a share, if it is near it and strictly between its ends.
  [[nodiscard]] std::optional<double> shareAt(const Edge& edge, Index v) const;
  [[nodiscard]] bool isOnePlace(Index a, Index b) const;
  /// The vertices near an edge, in order from its first one on.
  const std::vector<Index>& verticesOn(const Edge& edge);
  [[nodiscard]] std::vector<Index> findVerticesOn(const Edge& edge);
  /// Visits the triangles that have an edge: needles may have come together so that it has several on one side.
  template <class Visit>
  void visitAt(const Edge& edge, const Visit& visit);
  bool findTouched(Index broken);
  bool divide(Index t);
  bool addLoop(Index t, const Outline& loop);
  bool triangulate(Index t, Outline loop);
  [[nodiscard]] bool isEar(const Outline& loop, std::size_t i) const;
  [[nodiscard]] double shapeOf(const Outline& loop, std::size_t i) const;
  [[nodiscard]] bool isConforming();
  void apply();

  RepairedMesh& mesh_;
  double reach_ = 0;
  std::map<Edge, std::vector<Index>> on_;
  std::set<Index> known_;  ///< vertices near some edge
  std::vector<Index> touched_;
  std::vector<NewTriangle> made_;
  std::vector<Edge> together_;
  std::vector<Edge> obstacles_;  ///< edges where the outline of a triangle ran back over an obstacle
};

}  // namespace footfall::detail
