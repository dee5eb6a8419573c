// The sign of a difference of doubles, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::detail {

/// Sign of a - b - c. The numbers must be finite. The error of a - b is that of Knuth's two-sum (The Art of Computer
/// Programming 2, 4.2.2), which nothing but an overflow can falsify; then a - b is not near c.
inline int signOfDifference(double a, double b, double c) {
  const double difference = a - b;
  if (difference != c) return difference > c ? 1 : -1;  // rounding is monotonic
  const double part = a - difference;
  const double error = (a - (difference + part)) + (part - b);
  return (error > 0) - (error < 0);
}

}  // namespace footfall::detail
