// Giving each side of an obstacle edge vertices of its own, so that shared indices mean that an agent can cross.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {

struct SplitMesh {
  /// For each vertex the vertex of the mesh that it is a copy of, or -1 for a point in the middle of an edge.
  std::vector<Index> origins;
  /// For a point in the middle: the ends of its edge, as vertices of the mesh.
  std::vector<std::array<Index, 2>> middles;
  std::vector<MeshTriangle> triangles;  ///< obstacle flags only where walkable area lies on both sides
  std::vector<std::uint32_t> layers;    ///< one for each triangle, or empty
};

/// Splits vertices along obstacle edges: the corners of two triangles stay one vertex when one can turn around the
/// vertex from one to the other without crossing an obstacle edge. An edge whose sides still have the same two ends
/// (a wall with two free ends) gets a point in its middle on either side. `topology` is that of the mesh. `poll` is
/// called now and then and may throw to cancel.
SplitMesh splitAtObstacleEdges(
    const WalkableMesh& mesh, const MeshTopology& topology, const std::function<void()>& poll = [] {});

}  // namespace footfall::detail
