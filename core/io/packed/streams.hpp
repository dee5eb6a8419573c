// Readers that stream vertices and faces to a packer without holding the file or its mesh whole in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/packed/environment_packer.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

// Each reader gives the same result as importing the file in its own frame, with the same numbers: vertices and faces
// go to the sink, `skipped` and `parts` to `head`. Each returns false for an unusual file and for an error; the caller
// then reads the file as a whole, which reports the error. Memory is bounded, apart from the list of parts.

/// OBJ. Throws InputError also for errors, with their lines. Reads the file twice where a polygon precedes its
/// vertices.
bool streamObj(const std::string& path, Environment& head, EnvironmentPacker& packer, RunContext* context);
/// PLY with the elements `vertex` and `face`, binary or ASCII. Numbers in text are the nearest doubles, whatever type
/// the file gives them.
bool streamPly(const std::string& path, Environment& head, MeshSink& sink, RunContext* context);
/// STL, binary or ASCII with a statement in each line; numbers in text are the nearest doubles.
bool streamStl(const std::string& path, Environment& head, MeshSink& sink, RunContext* context);

/// Binary glTF whose meshes are triangles with indices, in floats, in the file itself; without skins.
bool streamGlb(const std::string& path, Environment& head, EnvironmentPacker& packer, RunContext* context);

}  // namespace footfall::detail
