// The common grid of integers on which all coordinates of an environment lie: every double is an integer times a power
// of two.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/exact/error_double.hpp"

namespace footfall::detail {

/// Multiplies by 2^exponent. A product with a power of two is rounded like ldexp, if at all; but not all powers are
/// normal doubles.
class PowerOfTwo {
 public:
  explicit PowerOfTwo(int exponent)
      : exponent_(exponent), factor_(std::ldexp(1.0, exponent)), isNormal_(std::isnormal(factor_)) {}

  [[nodiscard]] double operator()(double x) const { return isNormal_ ? x * factor_ : std::ldexp(x, exponent_); }

 private:
  int exponent_;
  double factor_;
  bool isNormal_;
};

struct Grid {
  int low = 5000;   ///< all numbers are integers times 2^low
  int top = -5000;  ///< and smaller than 2^top in size

  void include(double x) {
    // A double has 52 digits after a leading 1, and 11 bits of exponent; the smallest doubles have no leading 1.
    const auto bits = std::bit_cast<std::uint64_t>(x);
    std::uint64_t digits = bits & ((std::uint64_t{1} << 52) - 1);
    int exponent = static_cast<int>(bits >> 52 & 2047) - 1022;
    if (exponent > -1022) {
      digits |= std::uint64_t{1} << 52;
    } else {
      if (digits == 0) return;
      exponent = -1021 - (std::countl_zero(digits) - 11);
    }
    const int unit = std::max(exponent - 53, -1074);
    if (const int last = unit + std::countr_zero(digits); last < low) low = last;
    if (exponent > top) top = exponent;
  }

  [[nodiscard]] bool empty() const { return top < low; }

  /// Bits of the largest coordinate as an integer of the grid: all are below 2^width.
  [[nodiscard]] int width() const { return empty() ? 0 : top - low; }

  /// True when doubles compute the orientation of three places on this grid without a rounding: a difference has one
  /// bit more than the coordinates, a product of two twice as many, and the difference of two products one more.
  [[nodiscard]] bool hasExactOrientations() const { return 2 * (width() + 1) + 1 <= 53; }

  /// Doubles compute with coordinates times this power of two, which scales the largest to just below 2^36.
  [[nodiscard]] int scaleExponent() const { return empty() ? 0 : kScaledTop - top; }

  /// The reliability of computed signs for numbers on this grid, scaled by 2^scale. The predicates reach degree 26 in
  /// the coordinates, with at most 30 bits of sums. While all numbers are below 2^38, no product exceeds 2^(26 * 38 +
  /// 30) < 2^1023; while all are multiples of 2^-38, none is below 2^-988, so nothing underflows. On a finer grid an
  /// underflow, at most 2^-1074 each and fewer than 2^10 of them, is multiplied by less than 2^(39 * 25 + 30): together
  /// below 2^-59, far below the slack, and a computed zero proves nothing. Beyond 2^38 doubles decide nothing.
  [[nodiscard]] SignRule signRule(int scale) const {
    if (empty() || (low + scale >= -38 && top + scale <= 38)) return {0, true};
    if (top + scale <= 38) return {0x1p-40, false};
    return {std::numeric_limits<double>::infinity(), false};
  }

 private:
  static constexpr int kScaledTop = 36;
};

}  // namespace footfall::detail
