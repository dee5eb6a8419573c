// A walkable mesh that is no longer exact, from which the product is made without the environment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh/walkable_mesh.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Triangles, places and `exact` as roundVertices() has them of a WalkableMesh, before anything is split or repaired.
struct PlacedMesh {
  std::vector<MeshTriangle> triangles;  ///< `face` is an index into `sources`
  std::vector<Vec3> places;             ///< each coordinate the nearest double to the exact one
  std::vector<char> exact;              ///< 1 for each vertex whose place is exact
  std::vector<std::uint32_t> sources;   ///< input triangle of each face
  std::vector<std::uint32_t> layers;    ///< one per triangle, or empty
  std::vector<MeshLink> links;          ///< those without a triangle at either edge are left out
};

/// The result of makeNavigationMesh() for a state with that mesh, without drops; the frame is left empty.
std::shared_ptr<NavigationMesh> makeNavigationMesh(const PlacedMesh& mesh, RunContext& context);

}  // namespace footfall::detail
