// Writing the navigation mesh as a resource of Godot.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "core/base/poll.hpp"
#include "footfall/io.hpp"

namespace footfall::detail {

struct GodotFile {
  std::string text;
  double largestError = 0;  ///< in metres, by which rounding to floats moved a coordinate
  std::size_t polygons = 0;
};

/// Writes a NavigationMesh as a text resource of Godot 4 (format 3), or of Godot 3 (format 2) where `options.godot`
/// chooses it, in metres and Y up. Polygons are clockwise from above, as Godot bakes them, convex and flat to within 1
/// mm (mergeTriangles()), with any number of corners. Godot reads them as fans of triangles around their first corner.
///
/// Godot joins edges whose ends fall into the same squares of its map, and ignores their indices. So a step or a gap is
/// written as a polygon between both borders. An edge with several links is divided, because Godot joins at most two
/// polygons on an edge. One of the two sides of an obstacle edge gets a corner in its middle, which keeps the sides
/// apart. The resource holds the agent's height, radius, step and slope, where they are known. Throws what engineMesh()
/// throws, InputError for another version of Godot, and what `poll` throws.
GodotFile formatGodot(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options = {},
                      Poll poll = {});

}  // namespace footfall::detail
