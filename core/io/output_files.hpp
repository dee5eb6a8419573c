// Files that belong together and are written together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/poll.hpp"

namespace footfall::detail {

/// A file to write.
struct OutputFile {
  std::string path, bytes;
};

/// What the file of links is called beside those of layers.
inline constexpr std::string_view kLinksSuffix = "links";

/// "plan-0.svg" for "plan.svg" and "0".
std::string besideName(const std::string& path, const std::string& suffix);

/// The files that are there already and may be replaced by an export of that name which has a file for each page or
/// layer: the name itself, then with numbers and "links" beside it, "plan-2.svg" before "plan-10.svg".
std::vector<std::string> existingOutputs(const std::string& path);

/// Writes all of them beside their targets, and renames them when the last one is whole: where one cannot be written,
/// or `poll` throws, all targets stay as they were. (Between two renames only a kill or a broken disk can part them.)
/// Pipes and devices are written to in their place. Throws RunError as writeFileSafely() does, and what `poll` throws.
void writeFilesSafely(std::span<const OutputFile> files, Poll poll = {});

}  // namespace footfall::detail
