// Drops of an export: which edges and triangles of the mesh their lines belong to.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A drop as a line: where the agent leaves the border, and where it lands.
using DropLine = std::array<Vec3, 2>;

/// Adds a drop for each two lines, with the edge of the border nearest to its starts, and the triangle nearest to its
/// landings that lies outwards of them. A line too many, and a mesh without triangles, add none.
void completeDrops(const std::vector<DropLine>& lines, NavigationMesh& mesh);

}  // namespace footfall::detail
