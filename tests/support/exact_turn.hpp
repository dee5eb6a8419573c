// The sign of a turn in rationals, without reducing a fraction: that costs more than all else about them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

namespace footfall::test {

/// Numerator and denominator, which is above 0; they may have common divisors.
struct Fraction {
  mpz_class over, under;
};
inline Fraction difference(const mpq_class& a, const mpq_class& b) {
  return {a.get_num() * b.get_den() - b.get_num() * a.get_den(), a.get_den() * b.get_den()};
}

/// 1 where the way from (ax, ay) over (bx, by) to (cx, cy) turns left, -1 where it turns right, 0 where it is straight.
inline int exactTurn(const mpq_class& ax, const mpq_class& ay, const mpq_class& bx, const mpq_class& by,
                     const mpq_class& cx, const mpq_class& cy) {
  const Fraction ux = difference(bx, ax), uy = difference(by, ay), vx = difference(cx, ax), vy = difference(cy, ay);
  const mpz_class left = ux.over * vy.over * uy.under * vx.under, right = uy.over * vx.over * ux.under * vy.under;
  return (left > right ? 1 : 0) - (left < right ? 1 : 0);
}

}  // namespace footfall::test
