// The sign of the area of a triangle in the plan, by pairs of doubles: what a plain filter leaves open is nearly always
// zero or decided by some bits more.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "core/exact/error_double.hpp"

namespace footfall::detail {

/// A number as the sum of two doubles, the second of which is at most half a unit in the last place of the first.
struct DoublePair {
  double high = 0, low = 0;

  static DoublePair difference(double a, double b) {
    const double high = a - b, part = high - a;
    return {high, (a - (high - part)) - (b + part)};
  }
  static DoublePair product(double a, double b) {
    const double high = a * b;
    return {high, std::fma(a, b, -high)};
  }
};

/// Sign of the orientation of three places of the plan; nothing where pairs of doubles cannot decide. Nothing may
/// underflow in products of four coordinates.
///
/// Proof, u = 2^-53. With A + a and so on for the differences, the area is (A + a)(B + b) - (C + c)(D + d). Without
/// rests it is AB - CD, and rounding is monotone: rounded products that differ are in the order of the products, and
/// where they are equal, the residuals differ by what the products do. With rests, AB and CD are exact pairs, and the
/// difference of their first parts is one. All that is added to that has at most eight roundings of each term, and
/// leaves out ab and cd, which are at most u |Ab| and u |Cd|; the last sum is rounded by u of itself. 16 u of all terms
/// and 2 u of the sum cover that and the rounding of the bound.
inline MaybeSign signOfArea(const std::array<double, 2>& p, const std::array<double, 2>& q,
                            const std::array<double, 2>& r) {
  constexpr double kU = 0x1p-53;
  const DoublePair ax = DoublePair::difference(p[0], r[0]), ay = DoublePair::difference(p[1], r[1]);
  const DoublePair bx = DoublePair::difference(q[0], r[0]), by = DoublePair::difference(q[1], r[1]);
  const DoublePair left = DoublePair::product(ax.high, by.high), right = DoublePair::product(ay.high, bx.high);
  if (ax.low == 0 && ay.low == 0 && bx.low == 0 && by.low == 0) {
    if (left.high != right.high) return left.high > right.high ? 1 : -1;
    return (left.low > right.low) - (left.low < right.low);
  }
  const DoublePair main = DoublePair::difference(left.high, right.high);
  const double leftRest = ax.high * by.low + ax.low * by.high, rightRest = ay.high * bx.low + ay.low * bx.high;
  const double sum = main.high + ((main.low + (left.low - right.low)) + (leftRest - rightRest));
  const double terms = std::fabs(main.low) + std::fabs(left.low) + std::fabs(right.low) + std::fabs(ax.high * by.low) +
                       std::fabs(ax.low * by.high) + std::fabs(ay.high * bx.low) + std::fabs(ay.low * bx.high);
  const double bound = terms * (16 * kU) + std::fabs(sum) * (2 * kU);
  if (sum > bound) return 1;
  if (sum < -bound) return -1;
  return std::nullopt;
}

}  // namespace footfall::detail
