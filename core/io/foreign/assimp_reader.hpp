// Reading through Assimp, in the process of footfall-import.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Fills `vertices`, `triangles`, `skipped`, `parts` and `partOf` with the meshes of all nodes, in the file's own frame
/// (no axis is turned, no unit applied). Assimp stores floats; node transforms are multiplied and applied in double. A
/// mirroring transform reverses the winding, as glTF 2.0 (3.7.4) requires. Vertices are not merged; polygons are split
/// by triangulatePolygon().
///
/// Throws InputError, one line with Assimp's message, for a file that it cannot read, for coordinates that are NaN or
/// infinite and indices out of range; Cancelled when `context` (may be null) was cancelled.
FileFrame readWithAssimp(const std::string& path, Environment& environment, RunContext* context);

}  // namespace footfall::detail
