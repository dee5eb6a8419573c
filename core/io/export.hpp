// Writing the navigation mesh as OBJ (model, Exports); other formats: gltf_export.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/base/poll.hpp"
#include "footfall/io.hpp"

namespace footfall::detail {

/// Checks a scale: throws InputError where it is not above 0 or not finite, or makes coordinates infinite.
void checkScale(const ExportOptions& options, const NavigationMesh& mesh);

/// Returns the OBJ text in the frame and units of the mesh's file, unless `options` choose others. The comments of the
/// text state its frame and units. The same input gives the same bytes. Throws what `poll` throws.
std::string formatObj(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options = {},
                      std::span<const ExportExtra> extras = {}, Poll poll = {});

/// Throws the RunError of writeFileSafely() for failures that can be detected without writing: a folder, a missing
/// folder, no permission, a name that is too long.
void checkWritable(const std::string& path);

/// Writes beside `path` and renames, so that a failure or a kill leaves an earlier file intact. A symbolic link stays a
/// link, and its target is written. Temporary files of dead processes beside the target are removed. Throws RunError
/// with what, where and what to do (read-only target, full disk, missing folder, a directory), and what `poll` throws.
void writeFileSafely(const std::string& path, const std::string& text, Poll poll = {});

}  // namespace footfall::detail
