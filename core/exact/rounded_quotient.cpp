// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/rounded_quotient.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace footfall::detail {
namespace {

// x * 2^shift (shift >= 0) into `limbs`; returns the number of limbs.
int shiftInto(mp_limb_t* limbs, IntegerView x, int shift) {
  const int whole = shift / 64, part = shift % 64;
  std::fill_n(limbs, whole, mp_limb_t{0});
  int count = whole + x.count();
  if (part == 0) {
    std::copy_n(x.limbs, x.count(), limbs + whole);
  } else {
    const mp_limb_t carry = mpn_lshift(limbs + whole, x.limbs, x.count(), static_cast<unsigned>(part));
    if (carry != 0) limbs[count++] = carry;
  }
  return count;
}

// The nearest double of (quotient + a fraction below 1) * 2^exponent; `more` is true where the fraction is not 0.
double nearest(std::uint64_t quotient, bool more, int exponent, bool* exact) {
  const int top = exponent + 63 - std::countl_zero(quotient);
  const int lowest = std::max(top - 52, -1074);  // the exponent of the last bit that a double keeps
  const int dropped = lowest - exponent;         // at least 10, because the quotient has 63 or 64 bits
  std::uint64_t kept = 0;
  bool lost = more, up = false;
  if (dropped <= 64) {
    kept = dropped == 64 ? 0 : quotient >> dropped;
    const std::uint64_t rest = dropped == 64 ? quotient : quotient & ((1ULL << dropped) - 1);
    const std::uint64_t half = 1ULL << (dropped - 1);
    up = rest > half || (rest == half && (more || (kept & 1) != 0));
    lost = lost || rest != 0;
  } else {
    lost = true;  // The value is below half of the smallest double.
  }
  const double result = std::ldexp(static_cast<double>(kept + static_cast<std::uint64_t>(up)), lowest);
  if (exact != nullptr && (lost || std::isinf(result))) *exact = false;
  return result;
}

}  // namespace

double roundedQuotient(IntegerView numerator, IntegerView denominator, int exponent, bool* exact) {
  if (numerator.size == 0) return 0;
  // Shifted so that the quotient lies between 2^62 and 2^64.
  const int shift = 63 - (numerator.width() - denominator.width());
  const int limbs =
      std::max(numerator.width() + std::max(shift, 0), denominator.width() + std::max(-shift, 0)) / 64 + 2;
  constexpr int kOnStack = FixedInteger::kCapacity + 2;
  std::array<mp_limb_t, 3 * kOnStack> onStack;  // NOLINT: set before use
  std::vector<mp_limb_t> onHeap;
  mp_limb_t* const scratch = limbs <= kOnStack ? onStack.data() : (onHeap.resize(3 * limbs), onHeap.data());
  mp_limb_t *const n = scratch, *const d = scratch + limbs, *const remainder = scratch + 2 * limbs;
  const int countN = shiftInto(n, numerator, std::max(shift, 0));
  const int countD = shiftInto(d, denominator, std::max(-shift, 0));
  std::array<mp_limb_t, 3> quotient{};
  mpn_tdiv_qr(quotient.data(), remainder, 0, n, countN, d, countD);
  bool more = false;
  for (int i = 0; i < countD && !more; ++i) more = remainder[i] != 0;
  const double result = nearest(quotient[0], more, exponent - shift, exact);
  return ((numerator.size < 0) != (denominator.size < 0) ? -result : result) + 0.0;
}

}  // namespace footfall::detail
