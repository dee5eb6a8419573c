// Reads any file of a foreign format in footfall-import.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Reads a file as readForeign() does, in this process.
FileFrame readForeignFile(const std::string& path, Environment& environment);

}  // namespace footfall::detail
