// Distances in the plan, where heights do not count.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "footfall/geometry.hpp"

namespace footfall::detail {

inline double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace footfall::detail
