// The side of a line on which a point lies, from rounded coordinates with a bound of their error.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "core/exact/error_double.hpp"

namespace footfall::detail {

/// Side of the origin on the line from a to b, +1 left, of rounded coordinates with an error bound for each; never 0.
inline MaybeSign filteredTurn(const std::array<double, 2>& a, double errorA, const std::array<double, 2>& b,
                              double errorB, double slack) {
  const double left = a[0] * b[1], right = a[1] * b[0];
  const double value = left - right;
  // First the coordinates' own errors, then 4 u (|l| + |r|) for the arithmetic (differences, products, sum); the factor
  // 9 and kInflate cover the rounding of the bound itself.
  const double bound = ((std::fabs(a[0]) + std::fabs(a[1])) * errorB + (std::fabs(b[0]) + std::fabs(b[1])) * errorA +
                        2 * errorA * errorB + (std::fabs(left) + std::fabs(right)) * (9 * 0x1p-53)) *
                           kInflate +
                       slack;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return std::nullopt;
}

}  // namespace footfall::detail
