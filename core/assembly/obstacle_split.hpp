// Giving each side of an obstacle edge vertices of its own, so that shared indices mean that an agent can cross.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {

struct SplitVertex {
  Index origin = -1;                    ///< the vertex of the mesh that it is a copy of, or -1 in the middle of an edge
  std::array<Index, 2> middle{-1, -1};  ///< ends of the edge, as vertices of the mesh, for the vertex in its middle
};
/// The triangles have obstacle flags only where walkable area lies on both sides.
using SplitMesh = TriangleMesh<SplitVertex>;

/// Splits vertices along obstacle edges: the corners of two triangles stay one vertex when one can turn around the
/// vertex from one to the other without crossing an obstacle edge. An edge whose sides still have the same two ends
/// (a wall with two free ends) gets a point in its middle on either side. `layers` may be empty; `adjacency` is that of
/// the triangles. `poll` is called now and then and may throw to cancel.
SplitMesh splitAtObstacleEdges(const std::vector<MeshTriangle>& triangles, const std::vector<std::uint32_t>& layers,
                               std::size_t vertexCount, const Adjacency& adjacency, Poll poll = {});

}  // namespace footfall::detail
