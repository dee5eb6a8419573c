// Which storeys of a building the layers of its walkable area lie on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// For each layer the names of the storeys of NavigationMesh::frame that hold a tenth of its area or more, from below
/// upwards, with commas between them. Empty where the file tells no storeys, or the mesh has no layers. A triangle is
/// on the highest storey that begins at most half a metre above its middle: floors are drawn at their storey's height,
/// or under what they are covered with.
std::vector<std::string> storeyNames(const NavigationMesh& mesh);

}  // namespace footfall::detail
