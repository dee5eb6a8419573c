// Packing an environment's file: `footfall pack`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/io/packed/environment_packer.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

struct PackResult {
  PackedCounts counts;
  bool isStreamed = false;  ///< the environment was never whole in memory
  std::vector<Text> notes;  ///< Environment::notes
};

/// Writes the environment of `path` (a file or a folder, as importEnvironment()) to `target` as a packed environment,
/// through a file beside it that is renamed. Importing it gives the environment of `path`, bit by bit. OBJ, PLY, STL
/// and binary glTF are streamed; unusual files of these formats and all other formats are read as a whole. The options
/// are packed as if the file declared them. Throws InputError as importing does, RunError as writeFileSafely() does,
/// Cancelled when `context` (may be null) was cancelled. The caller makes sure that `target` is no input file.
PackResult packEnvironment(const std::string& path, const std::string& target, const ImportOptions& options,
                           RunContext* context, const PackingMemory& memory = {});

}  // namespace footfall::detail
