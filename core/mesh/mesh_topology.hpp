// What the edges of a walkable mesh mean: obstacles, regions, connections.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/adjacency.hpp"
#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

inline bool hasObstacle(const std::vector<MeshTriangle>& triangles, Index side) {
  return (triangles[side / 3].obstacleEdges >> (side % 3) & 1) != 0;
}

/// An obstacle stands on the edge of these sides, seen from any of its triangles.
bool isObstacle(const std::vector<MeshTriangle>& triangles, std::span<const Index> sides);

/// For each triangle its region: triangles that share an edge which is not an obstacle edge belong to one (design,
/// AreaFilter). Regions are numbered from 0 in the order of their first triangles.
std::vector<Index> findRegions(const WalkableMesh& mesh, const Adjacency& topology, Index& regionCount);

/// Edges on which two layers meet; 0 when there are no layers.
std::uint64_t countConnections(const WalkableMesh& mesh, const Adjacency& topology);

}  // namespace footfall::detail
