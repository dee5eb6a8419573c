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

/// The OBJ text, in the frame and units of the mesh's file unless `options` say otherwise; then its comments state the
/// frame and the units that it is in. Same input, same bytes. Throws what `poll` throws.
std::string formatObj(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options = {},
                      std::span<const ExportExtra> extras = {}, Poll poll = {});

/// Throws RunError where writeFileSafely() would, as far as that is known without writing: a folder, a missing folder,
/// no permission, a name that is too long.
void checkWritable(const std::string& path);

/// Writes beside `path` and renames, so that a failure or a kill leaves an earlier file as it was. Throws RunError with
/// what, where and what to do (read-only target, full disk, missing folder, a directory), and what `poll` throws. A
/// link stays a link: what it leads to is written. Temporary files of processes that have died are removed beside it.
void writeFileSafely(const std::string& path, const std::string& text, Poll poll = {});

}  // namespace footfall::detail
