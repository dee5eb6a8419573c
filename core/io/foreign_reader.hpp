// Reading the formats of others in a process of its own, footfall-import: whatever a damaged file does to their readers
// ends that process alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/child_process.hpp"
#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Where footfall-import is: what the environment variable FOOTFALL_IMPORT names, else beside the library or program
/// that has this code, in libexec/footfall next to its folder, or one of two folders up, as in a build. Empty when it
/// is nowhere, or belongs to somebody else.
std::optional<std::string> findImportProgram();

/// What reading a file of so many bytes, companions included, may take: a minute and 20 seconds for each MiB; 1 GiB and
/// 200 bytes for each byte, and no more than four fifths of the machine's memory.
ChildLimits importLimits(std::uint64_t bytes);
/// Those for `path` with the buffers that a glTF file names.
ChildLimits importLimitsFor(const std::string& path);

/// How a format is called in messages: "glTF", "COLLADA", "IFC".
std::string formatName(std::string_view extension);

/// Extensions that footfall-import reads, lower case, without the dot.
const std::vector<std::string>& foreignExtensions();

/// Throws InputError for a reader that was ended by a limit, and what to do then.
void failBeyondLimits(const std::string& path, std::string_view format, ChildEnd end, const ChildLimits& limits);

/// Fills `vertices`, `triangles`, `skipped`, `parts`, `partOf` and `notes` in the file's own frame. Throws InputError,
/// one line with the file: what the reader says; its death, with the format and the signal; a limit that it passed; a
/// result that is cut off; no footfall-import. Throws Cancelled within 100 ms when `context` (may be null) was
/// cancelled.
FileFrame readForeign(const std::string& path, Environment& environment, const ChildLimits& limits,
                      RunContext* context);

}  // namespace footfall::detail
