// The parts of OBJ exports.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/base/number_text.hpp"
#include "core/io/export.hpp"

namespace footfall::detail {

/// Appends the comments at the top: the content ("Walkable area"), the source file, how the result was computed, and
/// its counts.
void appendHeader(std::string& text, std::string_view title, const SourceFrame& frame, const ExportHeader& header,
                  std::string_view content);

/// Appends a vertex in the frame of a file.
void appendVertex(std::string& text, const Vec3& p, UpAxis up);

/// Appends a statement with vertex indices; OBJ counts from 1.
template <std::size_t Count>
void appendElement(std::string& text, char statement, const std::array<std::uint32_t, Count>& indices) {
  text += statement;
  for (const std::uint32_t index : indices) {
    text += ' ';
    appendNumber(text, std::uint64_t{index} + 1);
  }
  text += '\n';
}

}  // namespace footfall::detail
