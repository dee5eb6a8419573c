// What footfall-import does: any file of a foreign format into an environment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// As readForeign(), in this process.
FileFrame readForeignFile(const std::string& path, Environment& environment);

}  // namespace footfall::detail
