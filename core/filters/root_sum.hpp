// Sums of square roots, which areas of regions are: enclosed in doubles, and compared exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <span>

#include "core/exact/error_double.hpp"

namespace footfall::detail {

inline ErrorDouble squareRoot(ErrorDouble x) {
  // |sqrt(x) - q| = |x - q^2| / (sqrt(x) + q) <= |x - q^2| / q
  const double q = std::sqrt(x.value);
  const double residual = std::fabs(std::fma(-q, q, x.value));
  return {q, ((x.error + residual) / q) * kInflate};
}

/// Sign of (sum of the roots) - limit. 0 where they agree to 4096 bits, which counts as equal.
int compareRootSum(std::span<const mpq_class> squares, const mpq_class& limit);

}  // namespace footfall::detail
