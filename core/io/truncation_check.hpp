// Recognising cut-off PLY, STL and binary glTF files, which Assimp 5.2 accepts in part, or never returns from, or for
// which it takes as much memory as they say.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace footfall::detail {

/// Throws InputError when `text` is a PLY file with a header that is not as it should be (Assimp 5.2 writes where it
/// must not after some of those), without the end of its header or with fewer elements than its header says. In a
/// binary file with lists only the elements before the first list and the least size of the rest count.
void rejectTruncatedPly(const std::string& path, std::string_view text);

/// Throws InputError when `text` is an ASCII STL file whose last facet or solid has no end.
void rejectTruncatedStl(const std::string& path, std::string_view text);

/// Throws InputError when the file is a binary glTF whose first chunk is longer than the file.
void rejectTruncatedGlb(const std::string& path);

}  // namespace footfall::detail
