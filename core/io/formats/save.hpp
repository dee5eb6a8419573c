// A result in any of the formats of the table.
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
  std::vector<OutputFile> files;  ///< one, unless FormatDescriptor::hasFilesBeside
  double largestError = 0;        ///< in metres, by which rounding moved a coordinate
};

/// Other programs have files of other kinds with the same ending: buffers of glTF (.bin), materials of Godot (.tres).
/// Throws InputError where one of these would be replaced; what is no file or cannot be read is left to writing.
void checkReplaced(const std::string& path);

/// What save() writes to `path`, whose ending is not looked at; throws what it throws before it writes, and what `poll`
/// throws.
ExportFiles formatExport(ExportFormat format, const std::string& path, const NavigationMesh& mesh,
                         const ExportHeader& header, const ExportOptions& options,
                         std::span<const ExportExtra> extras = {}, Poll poll = {});

}  // namespace footfall::detail
