// The definition and the place of a vertex of a cut environment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <compare>

#include "core/exact/source_mesh.hpp"
#include "core/partitioning/partition.hpp"

namespace footfall::detail {

/// The same point of the surface always has the same form, in whatever cells and triangles it occurs.
struct CutVertex {
  enum Kind : Index {
    Source,  ///< vertex `a`
    OnEdge,  ///< the source edge of vertices (a < b) meets a border; in x when it meets two
    Inside   ///< a border in x and one in y cross inside triangle `a`
  };
  Index kind = Source;
  Index a = -1, b = -1;
  /// Numbers in Partition::borders; -1 where there is none.
  std::array<Index, 2> borders{-1, -1};
  auto operator<=>(const CutVertex&) const = default;

  /// The axis of the border of a point on an edge.
  [[nodiscard]] int axis() const { return borders[0] >= 0 ? 0 : 1; }
};

/// Exact decisions about such vertices. Immutable; shared by all threads.
class CutGeometry {
 public:
  CutGeometry(const SourceMesh& mesh, const Partition& partition) : mesh_(mesh), borders_(partition.borders) {}

  [[nodiscard]] const SourceMesh& mesh() const { return mesh_; }
  [[nodiscard]] double border(int axis, Index number) const {
    return borders_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(number)];
  }

  /// The point where a source edge crosses a border between its ends, in its one form.
  [[nodiscard]] CutVertex edgePoint(Index u, Index v, int axis, Index number) const;
  /// Sign of coordinate `axis` of a vertex minus that of a border.
  [[nodiscard]] int side(const CutVertex& vertex, int axis, Index number) const;
  /// Order of two different points of one edge, from its smaller vertex on.
  [[nodiscard]] bool isBefore(const CutVertex& p, const CutVertex& q) const;

  /// The exact place of a vertex in the environment's units.
  [[nodiscard]] std::array<mpq_class, 3> exactPlace(const CutVertex& vertex) const;
  /// The place of a vertex, each coordinate rounded to the nearest double.
  [[nodiscard]] Vec3 roundedPlace(const CutVertex& vertex) const;

 private:
  /// Side of the directed edge on which a border in x and one in y cross: +1 left, 0 on its line.
  [[nodiscard]] int cornerSide(Index u, Index v, Index x, Index y) const;

  const SourceMesh& mesh_;
  const std::array<std::vector<double>, 2>& borders_;
};

}  // namespace footfall::detail
