// Finds the edges and triangles of the mesh that the drop lines of an export belong to.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A drop as a line: where the agent leaves the border, and where it lands.
using DropLine = std::array<Vec3, 2>;

/// Adds a drop for each pair of lines. Its edge is the border edge nearest to the starts; its triangle is the one
/// nearest to the landings that lies outwards of them. An unpaired line, and a mesh without triangles, add none.
void completeDrops(const std::vector<DropLine>& lines, NavigationMesh& mesh);

}  // namespace footfall::detail
