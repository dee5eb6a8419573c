// Readers that give a packer vertices and faces without holding the file or its mesh whole in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/packed/environment_packer.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

// Each gives what importing the file has in the file's own frame, with the same numbers for everything: vertices and
// faces to the sink, `skipped` and `parts` to `head`. Each returns false where the file is not as plain as it needs,
// or has an error: then it must be read as a whole, which has a message for the error. Memory is bounded, but for the
// list of parts.

/// OBJ; throws InputError for errors, too, with their lines. Reads twice where a polygon comes before its vertices.
bool streamObj(const std::string& path, Environment& head, EnvironmentPacker& packer, RunContext* context);
/// PLY with the elements `vertex` and `face`, binary or ASCII. Numbers in text are the nearest doubles, whatever type
/// the file gives them.
bool streamPly(const std::string& path, Environment& head, MeshSink& sink, RunContext* context);
/// STL, binary or ASCII with a statement in each line; numbers in text are the nearest doubles.
bool streamStl(const std::string& path, Environment& head, MeshSink& sink, RunContext* context);

/// Binary glTF whose meshes are triangles with indices, in floats, in the file itself; without skins.
bool streamGlb(const std::string& path, Environment& head, EnvironmentPacker& packer, RunContext* context);

}  // namespace footfall::detail
