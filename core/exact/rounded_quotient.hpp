// Correctly rounded doubles of exact fractions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exact/fixed_integer.hpp"

namespace footfall::detail {

/// Nearest double of numerator / denominator * 2^exponent, ties to even, never a negative zero; overflow gives
/// infinity. `exact` (may be null) becomes false when something was lost and is left alone otherwise. Allocates only
/// where an operand is wider than FixedInteger.
double roundedQuotient(IntegerView numerator, IntegerView denominator, int exponent, bool* exact = nullptr);

}  // namespace footfall::detail
