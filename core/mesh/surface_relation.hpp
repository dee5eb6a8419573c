// Finds the triangles of a navigation mesh that an earlier mesh had already.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// Vertices correspond one to one, with equal coordinates. Triangles correspond one to one, too, corner by corner. So
/// two related triangles share an edge, or have vertices of their own there, exactly where they did before. Triangles
/// that are not found may still be there. kNoElement stands for none.
struct SurfaceRelation {
  std::vector<std::uint32_t> triangleBefore;  ///< number of each triangle in the earlier mesh
  std::vector<std::uint32_t> triangleNow;     ///< number now of each triangle of the earlier mesh
  std::vector<std::uint32_t> vertexNow;       ///< number now of each vertex of the earlier mesh, where it was needed
  std::size_t related = 0;                    ///< number of related triangles
};

/// Linear where the triangles that both meshes have come in nearly the same order.
SurfaceRelation relateSurfaces(const NavigationMesh& before, const NavigationMesh& now, Poll poll = {});

}  // namespace footfall::detail
