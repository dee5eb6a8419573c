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

/// A NavigationMesh as a text resource: of Godot 4 (format 3), or of Godot 3 (format 2) where `options.godot` says so;
/// metres, Y up, polygons clockwise from above, as Godot bakes them. Polygons are convex and flat to within 1 mm
/// (mergeTriangles()), with as many corners as that gives; Godot takes them for fans of triangles around their first
/// corner.
///
/// Godot joins edges whose ends are at the same places, by cells of its map, whatever their numbers. So a step or a gap
/// is a polygon between both borders (an edge with several of them is divided, as Godot joins two polygons on an edge
/// at most), and of the two sides of an obstacle edge one gets a corner in its middle, which
/// keeps them apart. Agent: height, radius, step and slope, where they are known. Throws what engineMesh() throws, and
/// InputError for another version, and what `poll` throws.
GodotFile formatGodot(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options = {},
                      Poll poll = {});

}  // namespace footfall::detail
