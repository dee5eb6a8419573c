// Links of the exact mesh in the product: the same stretches of border, between rounded vertices.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/mesh/walkable_mesh.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// `places` are those of the exact mesh's vertices, rounded; `moved` are places that repairs moved to others, in that
/// order; `product` has its vertices and triangles, and `borders` are those of its sides that no other one shares, in
/// any order. A border that repairs divided gives several links. A link is lost where rounding left nothing of one of
/// its edges, divided its two edges in different ways, or moved them apart or, over a gap, onto each other. A gap that
/// rounding closed is a step.
std::vector<StepLink> roundLinks(const std::vector<MeshLink>& links, const std::vector<Vec3>& places,
                                 const std::vector<std::array<Vec3, 2>>& moved, std::vector<Index> borders,
                                 const NavigationMesh& product);

}  // namespace footfall::detail
