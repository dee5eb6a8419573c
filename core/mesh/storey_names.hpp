// The storeys of a building on which its walkable area lies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// The names of the storeys of NavigationMesh::frame that hold a tenth of the area of some triangles or more, from
/// below upwards, with commas between them. Empty where the file has no storeys. A triangle is on the highest storey
/// that begins at most half a metre above its middle: floors are drawn at their storey's height, or under what they are
/// covered with.
std::string storeysOf(const NavigationMesh& mesh, std::span<const std::uint32_t> triangles);

/// The same for each layer; empty where the file has no storeys, or the mesh has no layers.
std::vector<std::string> storeyNames(const NavigationMesh& mesh);

}  // namespace footfall::detail
