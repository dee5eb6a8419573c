// A double with a running bound of its error, which is zero when every operation so far was exact.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The residual of each operation is computed without error (TwoSum for sums, a fused multiply-add for products), so on
// coordinates that come from a grid of few bits, as those of most game levels do, the bound stays zero and even
// degenerate decisions need no other arithmetic.
//
// Proof of the bounds, u = 2^-53: with exact residual r, a sum differs from its value by at most |r| + ea + eb and a
// product by at most |r| + |a| eb + |b| ea + ea eb. Each bound is evaluated with at most five roundings, each of which
// loses at most the factor (1 - u), and is then multiplied by 1 + 16 u: (1 - u)^6 (1 + 16 u) > 1. This holds while
// nothing underflows; SignRule says what is done about that. Overflow makes the bound infinite or NaN, which no
// comparison accepts.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace footfall::detail {

struct ErrorDouble {
  double value = 0;
  double error = 0;

  ErrorDouble() = default;
  ErrorDouble(double v, double e = 0) : value(v), error(e) {}  // NOLINT(google-explicit-constructor)
};

inline constexpr double kInflate = 1 + 16 * 0x1p-53;

inline ErrorDouble operator+(ErrorDouble a, ErrorDouble b) {
  const double sum = a.value + b.value;
  const double part = sum - a.value;
  const double residual = (a.value - (sum - part)) + (b.value - part);
  return {sum, (a.error + b.error + std::fabs(residual)) * kInflate};
}

inline ErrorDouble operator-(ErrorDouble a) { return {-a.value, a.error}; }

inline ErrorDouble operator-(ErrorDouble a, ErrorDouble b) { return a + (-b); }

inline ErrorDouble operator*(ErrorDouble a, ErrorDouble b) {
  const double product = a.value * b.value;
  const double residual = std::fma(a.value, b.value, -product);
  return {product,
          (std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error + std::fabs(residual)) *
              kInflate};
}

/// Quotient; the error is infinite when the divisor may be zero.
inline ErrorDouble operator/(ErrorDouble a, ErrorDouble b) {
  // |b| - eb may round up by u |b|: take that off again.
  const double smallest = std::fabs(b.value) * (1 - 0x1p-52) - b.error;
  if (!(smallest > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double quotient = a.value / b.value;
  const double residual = std::fma(quotient, -b.value, a.value);
  return {quotient, ((a.error + std::fabs(quotient) * b.error + std::fabs(residual)) / smallest) * kInflate};
}

/// -1, 0 or 1; nothing where doubles could not decide.
using MaybeSign = std::optional<int>;

/// The bound beyond which a computed sign is certain in one environment (chosen and proven in SourceMesh).
struct SignRule {
  double slack = 0;       ///< absolute bound of everything that underflow can have done
  bool zeroValid = true;  ///< a value of 0 with error 0 is exactly 0

  [[nodiscard]] MaybeSign operator()(ErrorDouble x) const {
    const double bound = x.error + slack;
    if (x.value > bound) return 1;
    if (x.value < -bound) return -1;
    if (zeroValid && x.error == 0 && x.value == 0) return 0;
    return std::nullopt;
  }
};

/// Sign of ax by - ay bx for rounded differences of doubles, never 0. Each factor and product loses at most u,
/// the difference one more: 4 u (|l| + |r|); 6 u covers the bound's own loss. `slack` stands for underflow.
inline MaybeSign filteredArea(double ax, double ay, double bx, double by, double slack) {
  const double left = ax * by, right = ay * bx;
  const double value = left - right;
  const double bound = (std::fabs(left) + std::fabs(right)) * (6 * 0x1p-53) + slack;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return std::nullopt;
}

}  // namespace footfall::detail
