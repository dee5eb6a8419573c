// Writing the navigation mesh for Detour, the run-time half of Recast.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "core/io/formats/detour_tiles.hpp"
#include "footfall/io.hpp"

namespace footfall::detail {

struct DetourFile {
  std::string bytes;
  double largestError = 0;  ///< in metres, by which rounding to floats moved a coordinate
  std::size_t tiles = 0, polygons = 0, jumps = 0;
};

/// Whether this build has Detour's library.
bool hasDetour();

/// A tile set as Recast's demo writes and reads it: "MSET", version 1, tiles of version 7, in metres and Y up
/// (detourTiles()). The tiles are made by Detour, which rounds to 16 bits; vertices are then put back to the floats of
/// the mesh. What is written has been added to a navigation mesh of Detour without an error. Header: the agent's
/// height, radius and step; the step is at least 1 cm, which Detour needs to find the ends of connections, and, where
/// there are several tiles, less than half the height, as Detour joins what meets on their borders within it.
///
/// Throws InputError where this build has no Detour, and what engineMesh() and detourTiles() do.
DetourFile formatDetour(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options = {},
                        const DetourLimits& limits = {}, Poll poll = {});

}  // namespace footfall::detail
