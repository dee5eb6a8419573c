// Decides which triangles are walls.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "footfall/geometry.hpp"

namespace footfall::detail {

/// True when a triangle stands upright: seen from above it has a length, and within roundings no area. For notes only,
/// because nearly upright triangles may count as either.
inline bool isUpright(const std::array<Vec3, 3>& p) {
  constexpr double kFlat = 1e-9;  // area in the plan, by the square of the longest side
  const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, std::hypot(p[(k + 1) % 3].x - p[k].x, p[(k + 1) % 3].y - p[k].y));
  return longest > 0 && std::fabs(area) <= kFlat * longest * longest;
}

}  // namespace footfall::detail
