// Reading a navigation mesh back from OBJ: Footfall's own exports with all that they hold, or any other surface.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

struct NavigationMeshFile {
  std::string path;
  NavigationMesh mesh;  ///< Z up; without sourceTriangles
  /// Names of the layers, by their number; one "walkable" or "all" where the file has no layers.
  std::vector<std::string> layerNames;
  bool isExport = false;  ///< has the comments that Footfall writes at the top
  UpAxis up = UpAxis::Y;  ///< the file's up axis
  std::optional<UpAxis> statedUp;
  std::optional<double> metresPerUnit;
  SkippedElements skipped;
};

/// Reads OBJ at double precision. Faces in groups "layer_N" get layer N, `l` elements in the groups "connections" and
/// "obstacle_edges" become those; anything else is one surface without layers. The up axis is `up` where given, else
/// the one that an export states, else `usualUp`. A file that is not Z up is turned as import does, which is exact.
///
/// Throws InputError with one line: what readObj() and readInputFile() refuse; no triangles, unless the file is an
/// export that says so; an export that does not hold what its own comments count, because it was cut off; coordinates
/// above 1e100, whose areas and distances no double would hold.
/// Throws Cancelled when `context` (may be null) was cancelled.
NavigationMeshFile readNavigationMesh(const std::string& path, std::optional<UpAxis> up = std::nullopt,
                                      UpAxis usualUp = UpAxis::Y, RunContext* context = nullptr);

}  // namespace footfall::detail
