// A folder as one environment: all meshes in it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// The files of a folder that load() reads, by name; not those of folders in it, nor hidden ones. Empty where `folder`
/// is none, or cannot be read.
std::vector<std::string> meshesInFolder(const std::string& folder);

/// All files of a folder, each read by `read` (turned to Z up), in one environment. Parts are named FILE, or FILE: MESH
/// where the file has parts. Up axis and unit are those of the files: Z up where axes differ. Throws InputError when
/// there are no files, or when a unit of one is not that of the others; and what `read` throws.
Environment readFolder(const std::string& folder, const std::function<Environment(const std::string& path)>& read);

}  // namespace footfall::detail
