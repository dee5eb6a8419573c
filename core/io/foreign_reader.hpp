// Reading foreign formats in a separate process, footfall-import. A damaged file can only end that process.
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

/// The path of footfall-import. It is the value of the environment variable FOOTFALL_IMPORT; else the program is looked
/// for beside the library or program that contains this code, in libexec/footfall next to its folder, and one or two
/// folders up, as in a build. Empty when it is not found, or is owned by another user.
std::optional<std::string> findImportProgram();

/// The limits for reading a file of `bytes` bytes, companions included: a minute and 20 seconds for each MiB; 1 GiB and
/// 200 bytes for each byte, and at most four fifths of the machine's memory.
ChildLimits importLimits(std::uint64_t bytes);
/// The limits for `path` and the buffers that a glTF file names.
ChildLimits importLimitsFor(const std::string& path);

/// The name of a format in messages: "glTF", "COLLADA", "IFC".
std::string formatName(std::string_view extension);

/// Extensions that footfall-import reads, lower case, without the dot.
const std::vector<std::string>& foreignExtensions();

/// Throws the InputError for a reader that passed a limit; the message says what to do.
void failBeyondLimits(const std::string& path, std::string_view format, ChildEnd end, const ChildLimits& limits);

/// Fills `vertices`, `triangles`, `skipped`, `parts`, `partOf` and `notes` in the file's own frame. Throws InputError,
/// one line with the file, for an error that the reader reports, a crash (with the format and the signal), a limit that
/// it passed, truncated output, or a missing footfall-import. Throws Cancelled within 100 ms when `context` (may be
/// null) was cancelled.
FileFrame readForeign(const std::string& path, Environment& environment, const ChildLimits& limits,
                      RunContext* context);

}  // namespace footfall::detail
