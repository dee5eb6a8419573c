// Finds the program or library that contains Footfall, beside which its other files are installed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace footfall::detail {

/// The library or program that contains this code, and the running program. The loader reports a program by the name
/// that it was started by, which may be no file name.
std::vector<std::filesystem::path> ownFiles();

}  // namespace footfall::detail
