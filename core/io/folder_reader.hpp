// Reading a folder as one environment that holds all its meshes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// The files of a folder that load() reads, sorted by name. Files in subfolders and hidden files are left out. Empty
/// where `folder` is not a folder or cannot be read.
std::vector<std::string> meshesInFolder(const std::string& folder);

/// Joins all files of a folder, each read by `read` (turned to Z up), in one environment. Parts are named FILE, or
/// FILE: MESH where the file has parts. Up axis and unit are those of the files; Z is up where axes differ. Throws
/// InputError when there are no files or when their units differ, and what `read` throws.
Environment readFolder(const std::string& folder, const std::function<Environment(const std::string& path)>& read);

}  // namespace footfall::detail
