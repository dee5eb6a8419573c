// Detects truncated PLY, STL and binary glTF files. Assimp 5.2 accepts some of them in part, never returns from others,
// and allocates as much memory as a file's header demands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace footfall::detail {

/// Throws InputError for a PLY file whose header is invalid (Assimp 5.2 writes out of bounds after some of those) or
/// cut off, or that has fewer elements than its header declares. In a binary file with lists, only the elements before
/// the first list and the least size of the rest are counted.
void rejectTruncatedPly(const std::string& path, std::string_view text);

/// Throws InputError when `text` is an ASCII STL file whose last facet or solid has no end.
void rejectTruncatedStl(const std::string& path, std::string_view text);

/// Throws InputError when the file is a binary glTF whose first chunk is longer than the file.
void rejectTruncatedGlb(const std::string& path);

}  // namespace footfall::detail
