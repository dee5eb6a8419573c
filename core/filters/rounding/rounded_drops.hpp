// Drops of the exact mesh in the product.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/base/poll.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// `places` are those of the state's mesh, rounded; `moved` are places that repairs moved to others, in that order;
/// `product` has its vertices and triangles, and `origins` the triangle of the mesh that each of these is (a part of).
/// A drop is lost where repairs left nothing of its edge or divided it, and
/// where nothing is left of the face in which it lands. `poll` may throw.
std::vector<DropLink> roundDrops(const WalkableState& state, const std::vector<Vec3>& places,
                                 const std::vector<std::array<Vec3, 2>>& moved, const NavigationMesh& product,
                                 const std::vector<std::uint32_t>& origins, Poll poll);

}  // namespace footfall::detail
