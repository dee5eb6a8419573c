// Reading everything but OBJ through Assimp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// What a file says about its own frame; empty where it says nothing.
struct FileFrame {
  std::optional<UpAxis> up;
  std::optional<double> metresPerUnit;
  bool areFloats = false;  ///< its numbers are floats, or were placed by matrices
  double gridStep = 0;     ///< a power of two of which all coordinates are multiples, where a converter rounded them
};

/// glTF 2.0, section 3.4: metres, Y up.
inline FileFrame gltfFrame() { return {UpAxis::Y, 1.0, true}; }

/// Fills `vertices`, `triangles`, `skipped`, `parts` and `partOf` in the file's own frame (no axis is turned, no unit
/// applied) with the meshes of all nodes. Assimp stores floats; node transforms are multiplied and applied in double,
/// and a mirroring one reverses the winding, as glTF 2.0 (3.7.4) asks. Vertices are not merged; polygons are split by
/// triangulatePolygon().
///
/// Throws InputError, one line with what Assimp says, for a file that it cannot read, for coordinates that are NaN or
/// infinite and indices out of range; Cancelled when `context` (may be null) was cancelled.
FileFrame readWithAssimp(const std::string& path, Environment& environment, RunContext* context);

/// Extensions that Assimp reads, lower case, without the dot.
std::vector<std::string> assimpExtensions();

}  // namespace footfall::detail
