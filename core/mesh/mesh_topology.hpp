// Edges of a mesh and who shares them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// All edges, each as the list of its sides: triangle `side / 3` has it from its corner `side % 3` to the next one.
struct MeshTopology {
  std::vector<Index>
      sides;  ///< grouped by edge, ascending within one; edges are sorted by their vertices, smaller first
  std::vector<Index> first;  ///< for each edge its first place in `sides`, and one more at the end

  [[nodiscard]] Index edgeCount() const { return static_cast<Index>(first.size()) - 1; }
  [[nodiscard]] std::span<const Index> sidesOf(Index edge) const {
    return {sides.data() + first[edge], static_cast<std::size_t>(first[edge + 1] - first[edge])};
  }
};

/// Linear in the mesh while no vertex has very many edges; on all threads. `poll` is called now and then, from any
/// thread, and may throw to cancel.
MeshTopology findEdges(
    const std::vector<MeshTriangle>& triangles, std::size_t vertexCount, const std::function<void()>& poll = [] {});

/// The corner of triangle t at which its side begins.
inline Index beginOf(const std::vector<MeshTriangle>& triangles, Index side) {
  return triangles[side / 3].corners[side % 3];
}

inline bool hasObstacle(const std::vector<MeshTriangle>& triangles, Index side) {
  return (triangles[side / 3].obstacleEdges >> (side % 3) & 1) != 0;
}

/// An obstacle stands on the edge of these sides, seen from any of its triangles.
bool isObstacle(const std::vector<MeshTriangle>& triangles, std::span<const Index> sides);

/// For each triangle its region: triangles that share an edge which is not an obstacle edge belong to one (design,
/// AreaFilter). Regions are numbered from 0 in the order of their first triangles.
std::vector<Index> findRegions(const WalkableMesh& mesh, const MeshTopology& topology, Index& regionCount);

/// Edges on which two layers meet; 0 when there are no layers.
std::uint64_t countConnections(const WalkableMesh& mesh, const MeshTopology& topology);

}  // namespace footfall::detail
