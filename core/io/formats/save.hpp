// A result in any of the formats of the table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/io/formats/format_table.hpp"

namespace footfall::detail {

struct ExportBytes {
  std::string bytes;
  double largestError = 0;  ///< in metres, by which rounding moved a coordinate
};

/// Other programs have files of other kinds with the same ending: buffers of glTF (.bin), materials of Godot (.tres).
/// Throws InputError where one of these would be replaced; what is no file or cannot be read is left to writing.
void checkReplaced(const std::string& path);

/// What save() writes; throws what it throws before it writes.
ExportBytes formatExport(ExportFormat format, const NavigationMesh& mesh, const ExportHeader& header,
                         const ExportOptions& options, std::span<const ExportExtra> extras = {});

}  // namespace footfall::detail
