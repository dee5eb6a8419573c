// Judging the shape of triangles by rounded coordinates: a nicety that decides nothing about the walkable area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace footfall::detail {

/// The distance inside a circle at which a corner is flipped, relative to the terms that decide: more than their
/// roundings, so that flips do not go round in circles.
inline constexpr double kWellInside = 0x1p-32;

/// True when the origin seems to lie well inside the circumcircle of the counter-clockwise triangle a, b, c. Whether a
/// flip is possible at all must be decided exactly.
inline bool isWellInsideCircle(const std::array<double, 2>& a, const std::array<double, 2>& b,
                               const std::array<double, 2>& c) {
  const auto squared = [](const std::array<double, 2>& p) { return p[0] * p[0] + p[1] * p[1]; };
  const double sa = squared(a), sb = squared(b), sc = squared(c);
  const double bc = b[0] * c[1], cb = b[1] * c[0], ca = c[0] * a[1], ac = c[1] * a[0], ab = a[0] * b[1],
               ba = a[1] * b[0];
  const double inside = sa * (bc - cb) + sb * (ca - ac) + sc * (ab - ba);
  if (!(inside > 0)) return false;  // true of most
  const double size = sa * (std::fabs(bc) + std::fabs(cb)) + sb * (std::fabs(ca) + std::fabs(ac)) +
                      sc * (std::fabs(ab) + std::fabs(ba));
  return inside > size * kWellInside;
}

}  // namespace footfall::detail
