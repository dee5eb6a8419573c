// Writing a result in any format of the table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/poll.hpp"
#include "core/io/formats/format_table.hpp"
#include "core/io/output_files.hpp"

namespace footfall::detail {

struct ExportFiles {
  std::vector<OutputFile> files;  ///< a single file unless FormatDescriptor::hasFilesBeside
  double largestError = 0;        ///< the largest distance, in metres, by which rounding moved a coordinate
};

/// Throws InputError where the target is a file of another kind with the same ending: buffers of glTF (.bin), materials
/// of Godot (.tres). Names that are no file or cannot be read are left to the writer.
void checkReplaced(const std::string& path);

/// Makes the files that save() writes to `path`, whose ending is not checked. Throws what save() throws before it
/// writes, and what `poll` throws.
ExportFiles formatExport(ExportFormat format, const std::string& path, const NavigationMesh& mesh,
                         const ExportHeader& header, const ExportOptions& options,
                         std::span<const ExportExtra> extras = {}, Poll poll = {});

}  // namespace footfall::detail
