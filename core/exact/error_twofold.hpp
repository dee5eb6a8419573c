// An unevaluated sum of two doubles with a running bound of its error: about 105 bits.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proof of the bounds, u = 2^-53. TwoSum and a fused multiply-add after a product are without error, so only the
// operations on the low parts round, each by at most u times its result. The quotient q of the high parts leaves a
// remainder that a double holds; with R the remainder of the whole dividend, R / b is taken as R / b.high, and |b.low|
// <= u |b.high|. A bound is a sum of at most ten terms with at most four roundings each, and is then multiplied by
// 1 + 16 u (kInflate). Second-order terms are below 3 u of the first-order ones beside them, which kInflate covers
// too. All of this holds while nothing overflows. Where something underflows, sums lose nothing, and products,
// remainders and bounds at most 2^-1074 each, for which the bound does not stand (twofold_places.cpp adds that).
#pragma once

#include <cmath>
#include <limits>

#include "core/exact/error_double.hpp"

namespace footfall::detail {

struct ErrorTwofold {
  double high = 0, low = 0;  ///< |low| <= u |high|
  double error = 0;

  ErrorTwofold() = default;
  ErrorTwofold(double value) : high(value) {}  // NOLINT(google-explicit-constructor)
  ErrorTwofold(double h, double l, double e) : high(h), low(l), error(e) {}

  /// The sum of two doubles, without error.
  static ErrorTwofold sum(double a, double b, double error = 0) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part), error};
  }
};

inline ErrorTwofold operator-(const ErrorTwofold& a) { return {-a.high, -a.low, a.error}; }

inline void negate(ErrorTwofold& x) { x = -x; }

inline ErrorTwofold operator+(const ErrorTwofold& a, const ErrorTwofold& b) {
  const ErrorTwofold sum = ErrorTwofold::sum(a.high, b.high);
  const double lows = a.low + b.low, rest = sum.low + lows;
  const double error = (a.error + b.error + (std::fabs(lows) + std::fabs(rest)) * 0x1p-53) * kInflate;
  return ErrorTwofold::sum(sum.high, rest, error);
}

inline ErrorTwofold operator-(const ErrorTwofold& a, const ErrorTwofold& b) { return a + (-b); }

inline ErrorTwofold operator*(const ErrorTwofold& a, const ErrorTwofold& b) {
  const double product = a.high * b.high, residual = std::fma(a.high, b.high, -product);
  const double left = a.high * b.low, right = a.low * b.high, rest = residual + (left + right);
  // The product of the low parts is left out.
  const double error =
      (std::fabs(a.high) * b.error + std::fabs(b.high) * a.error + a.error * b.error +
       ((std::fabs(left) + std::fabs(right)) * 2 + std::fabs(rest)) * 0x1p-53 + std::fabs(a.low * b.low)) *
      kInflate;
  return ErrorTwofold::sum(product, rest, error);
}

/// Quotient; the error is infinite when the divisor may be zero.
inline ErrorTwofold operator/(const ErrorTwofold& a, const ErrorTwofold& b) {
  const double size = std::fabs(b.high), smallest = size * (1 - 0x1p-51) - b.error;
  if (!(smallest > 0)) return {0, 0, std::numeric_limits<double>::infinity()};
  const double quotient = a.high / b.high, remainder = std::fma(-quotient, b.high, a.high);
  const double left = remainder + a.low, right = quotient * b.low, more = (left - right) / b.high;
  const double error =
      ((a.error + std::fabs(quotient) * b.error + (std::fabs(left) + std::fabs(right)) * 0x1p-53) / smallest +
       std::fabs(more) * (5 * 0x1p-53)) *
      kInflate;
  return ErrorTwofold::sum(quotient, more, error);
}

}  // namespace footfall::detail
