// Which drops lead from one part of a walkable area to another one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A drop on the way: where it is left and where one lands, on the lines from start to start and landing to landing.
struct DropStop {
  std::uint32_t drop = 0;
  Vec3 start, landing;
};

/// The drops from a place in one part to a place in another one; nothing where no drops lead there. Each part is
/// entered once, where the sum of straight lines so far is least (Dijkstra's algorithm over parts), and each drop is
/// left where it is nearest to the place of entry.
std::optional<std::vector<DropStop>> findDropRoute(const NavigationMesh& mesh, const SurfaceTopology& topology,
                                                   const Vec3& from, std::uint32_t fromTriangle, const Vec3& to,
                                                   std::uint32_t toTriangle);

}  // namespace footfall::detail
