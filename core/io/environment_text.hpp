// Writing an environment as OBJ, with the coordinates that runs use.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// Writes the vertices and triangles of an environment, in the frame and units of its file and without its parts.
/// Reading the text as OBJ with the same up axis gives the same coordinates to the last bit.
std::string formatEnvironment(const Environment& environment);

}  // namespace footfall::detail
