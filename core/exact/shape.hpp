// Judging the shape of triangles by rounded coordinates: a nicety that decides nothing about the walkable area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace footfall::detail {

/// True when the origin seems to lie well inside the circumcircle of the counter-clockwise triangle a, b, c. The margin
/// keeps flips from going round in circles; whether a flip is possible at all must be decided exactly.
inline bool isWellInsideCircle(const std::array<double, 2>& a, const std::array<double, 2>& b,
                               const std::array<double, 2>& c) {
  const auto squared = [](const std::array<double, 2>& p) { return p[0] * p[0] + p[1] * p[1]; };
  const auto term = [&](const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r,
                        double& size) {
    const double left = q[0] * r[1], right = q[1] * r[0];
    size += squared(p) * (std::fabs(left) + std::fabs(right));
    return squared(p) * (left - right);
  };
  double size = 0;
  const double inside = term(a, b, c, size) + term(b, c, a, size) + term(c, a, b, size);
  return inside > size * 0x1p-32;
}

}  // namespace footfall::detail
