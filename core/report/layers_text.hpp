// The numbers of layers and connections of a result, and how many are needed at least.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "footfall/navigation_mesh.hpp"

namespace footfall {

/// "16 layers (at least 15)", "3 layers (as few as possible)" or "1 layer".
std::string layersText(const NavigationMesh& mesh);

/// "58 connections (at least 7)", "2 connections (as few as possible)", "1 connection" or "0 connections".
std::string connectionsText(const NavigationMesh& mesh);

}  // namespace footfall
