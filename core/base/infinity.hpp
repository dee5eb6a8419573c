// Infinity as a double: the distance to something that does not exist.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace footfall::detail {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace footfall::detail
