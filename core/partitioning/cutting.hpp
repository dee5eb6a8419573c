// Cuts an environment along the borders of its cells, without a seam (thesis 4.3, algorithms 1 and 2, figures 6 and
// 13).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/partitioning/cut_vertex.hpp"
#include "core/partitioning/partition.hpp"

namespace footfall::detail {

struct CutTriangle {
  std::array<Index, 3> corners{};  ///< numbers of vertices; turned as the source triangle is
  Index source = -1;               ///< triangle of the mesh
  Index cell = -1;
  bool operator==(const CutTriangle&) const = default;
};

/// Exactly, the pieces of a triangle tile it, none is degenerate, and no vertex lies inside a side of a piece of the
/// same triangle or of one that shares the source edge. Cells are half-open: what lies on a border alone belongs to the
/// upper cell, which is the positive side of algorithm 1. Cuts between heights divide no triangle; its lowest corner
/// decides.
struct CutEnvironment {
  std::vector<CutVertex> vertices;     ///< those of the mesh under their own numbers, then cut points
  std::vector<Vec3> places;            ///< places of the vertices, rounded to the nearest doubles
  std::vector<CutTriangle> triangles;  ///< sorted by source triangle
  /// The number of triangles that `round` left out because rounding moved corners of theirs to one place.
  std::uint64_t closedTriangles = 0;
};

/// Cuts the triangles with `included[t] != 0` (empty: all), walkable or rejected, including upright ones. Degenerate
/// ones stay as they are, in the cell of their first corner. With `round`, the rounded places are the vertices (thesis
/// 5.1.1): vertices that coincide are merged, and only rounding can break the guarantees above.
/// CutGeometry::exactPlace() gives the exact place of a vertex. Parallel; deterministic; `poll` is called every few
/// milliseconds, by any thread, and may throw to cancel.
CutEnvironment cutEnvironment(const SourceMesh& mesh, const Partition& partition, std::span<const char> included,
                              bool round, Poll poll = {});

}  // namespace footfall::detail
