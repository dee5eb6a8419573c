// Reading environments from files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Reads OBJ at double precision, and everything else that Assimp reads through Assimp (floats), node transforms
/// applied, polygons triangulated. Throws InputError with one line that says file, place and what to do: missing,
/// a directory, no permission, empty, truncated, not a mesh, no triangles, NaN or infinite coordinates, indices out
/// of range. Throws Cancelled when the context was cancelled while reading.
std::shared_ptr<const Environment> importEnvironment(const std::string& path, const ImportOptions& options = {},
                                                     RunContext* context = nullptr);

/// File name extensions that importEnvironment reads, lower case, without the dot ("obj", "gltf", ...).
std::vector<std::string> importableExtensions();

}  // namespace footfall::detail
