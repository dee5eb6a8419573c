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
  double largestError = 0;  ///< the largest distance, in metres, by which rounding to floats moved a coordinate
  std::size_t tiles = 0, polygons = 0, jumps = 0;
};

/// Returns whether this build has Detour's library.
bool hasDetour();

/// Writes a tile set as Recast's demo writes and reads it: "MSET", version 1, tiles of version 7, in metres and Y up
/// (detourTiles()). Detour makes the tiles and rounds to 16 bits; vertices are then set back to the floats of the mesh.
/// Each file has been added to a navigation mesh of Detour without an error. The header has the agent's height, radius
/// and step. The step is at least 1 cm, which Detour needs to find the ends of connections; where there are several
/// tiles it is less than half the height, because Detour joins polygons on their borders within it.
///
/// Throws InputError where this build has no Detour, and what engineMesh() and detourTiles() throw.
DetourFile formatDetour(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options = {},
                        const DetourLimits& limits = {}, Poll poll = {});

}  // namespace footfall::detail
