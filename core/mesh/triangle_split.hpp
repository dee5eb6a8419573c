// Cutting one triangle at vertices that lie on its edges, without further vertices.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// The vertices strictly inside each edge (corner k to k + 1), in that order; null or empty when there are none.
using EdgeVertices = std::array<const std::vector<Index>*, 3>;

/// Appends the pieces; obstacle flags stay on the pieces of their edge. None of them is degenerate when the vertices
/// lie on the edges.
void splitTriangle(const MeshTriangle& triangle, const EdgeVertices& on, std::vector<MeshTriangle>& result);

}  // namespace footfall::detail
