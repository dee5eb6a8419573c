// Whole numbers on the stack, as wide as the exact predicates can need; they never allocate.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proof of the widths. All coordinates, heights and borders are integers below 2^W in size (Grid::width()), and x < y
// bits stands for |x| < 2^y. With D = W + 1:
//   difference of two coordinates      D
//   normal (two products)              2D + 1
//   height over a plane                three products of 3D + 1 and one of 2D + 1 + W: 3D + 3
//   edge line (a, b, c)                D, D, 2D + 1; a border (1, 0, c) or (0, 1, c) is narrower: 1, 1, D
//   trace line (a, b, c)               4D + 3, 4D + 3; c: 2 * 3 * 2^(5D + 2) + 2^(5D + 1) < 2^(5D + 5)
//   point (X and Y, w)
//     edge x edge                      3D + 2, 2D + 1
//     edge x plane                     4D + 4, 3D + 4
//     edge x trace                     6D + 6, 5D + 4
//     trace x trace                    9D + 9, 8D + 7
// and from these, where trace x trace and the trace line are the widest operands,
//   order of two points                X w' - X' w: 17D + 17
//   side of a line at a point          aX, bY: 13D + 12, cw: 13D + 12; together 13D + 14
//   heights of two planes at a point   d w - nx X - ny Y: 11D + 12; times a normal, twice: 13D + 14
//   orientation of three points        X (Y' w'' - Y'' w'): 26D + 26, three of them: 26D + 28
//   point on the grid, for rounding    x, y: 9D + 10; z: 11D + 12 over 10D + 8
// The widest is the orientation. A product may be written with one limb more than it needs, and operands round up to
// whole limbs: two limbs more than the bits need are always enough.
#pragma once

#include <gmp.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <utility>

namespace footfall::detail {

static_assert(GMP_NUMB_BITS == 64);

/// A whole number that is kept elsewhere: limbs, lowest first, no leading zeros; `size` is their number with the sign.
struct IntegerView {
  const mp_limb_t* limbs = nullptr;
  int size = 0;
  [[nodiscard]] int count() const { return size < 0 ? -size : size; }
  /// Bits of the absolute value.
  [[nodiscard]] int width() const { return size == 0 ? 0 : 64 * count() - std::countl_zero(limbs[count() - 1]); }
};

inline int sgn(IntegerView x) { return (x.size > 0) - (x.size < 0); }

class FixedInteger;
FixedInteger operator*(IntegerView a, IntegerView b);
FixedInteger operator+(IntegerView a, IntegerView b);
FixedInteger operator-(IntegerView a, IntegerView b);

/// Sign and magnitude of up to kCapacity limbs. What must not happen, and does not where PlanKernel uses it (proof
/// above), is a result that is wider.
class FixedInteger {
 public:
  static constexpr int kCapacity = 64;

  FixedInteger() {}  // NOLINT(modernize-use-equals-default): `= default` would set all limbs where it says T()
  explicit FixedInteger(__int128 value) {
    const auto magnitude = value < 0 ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
    limbs_[0] = static_cast<mp_limb_t>(magnitude);
    limbs_[1] = static_cast<mp_limb_t>(magnitude >> 64);
    const int count = limbs_[1] != 0 ? 2 : static_cast<int>(limbs_[0] != 0);
    size_ = value < 0 ? -count : count;
  }
  explicit FixedInteger(IntegerView x) : size_(x.size) {
    assert(x.count() <= kCapacity);
    copy(x);
  }
  FixedInteger(const FixedInteger& o) : FixedInteger(IntegerView(o)) {}
  FixedInteger& operator=(const FixedInteger& o) {
    size_ = o.size_;
    copy(o);
    return *this;
  }
  operator IntegerView() const { return {limbs_, size_}; }  // NOLINT(google-explicit-constructor)

  void negate() { size_ = -size_; }

  /// digits * 2^shift, shift >= 0.
  static FixedInteger shifted(std::uint64_t digits, int shift) {
    FixedInteger r;
    if (digits == 0) return r;
    const auto whole = static_cast<unsigned>(shift) / 64, part = static_cast<unsigned>(shift) % 64;
    assert(whole + 2 <= kCapacity);
    for (unsigned i = 0; i < whole; ++i) r.limbs_[i] = 0;
    r.limbs_[whole] = digits << part;
    r.limbs_[whole + 1] = digits >> 1 >> (63 - part);
    r.size_ = static_cast<int>(whole) + 1 + static_cast<int>(r.limbs_[whole + 1] != 0);
    if (r.limbs_[whole] == 0 && r.limbs_[whole + 1] == 0) r.size_ = 0;
    return r;
  }

  friend FixedInteger operator*(IntegerView a, IntegerView b) {
    FixedInteger r;
    if (a.size == 0 || b.size == 0) return r;
    if (a.count() < b.count()) std::swap(a, b);
    const int n = a.count(), m = b.count();
    assert(n + m <= kCapacity);
    if (n <= kShort) {
      r.limbs_[n] = r.multiplyAdd(0, a, b.limbs[0], true);
      for (int i = 1; i < m; ++i) r.limbs_[n + i] = r.multiplyAdd(i, a, b.limbs[i], false);
    } else {
      mpn_mul(r.limbs_, a.limbs, n, b.limbs, m);
    }
    r.size_ = n + m - static_cast<int>(r.limbs_[n + m - 1] == 0);
    if ((a.size < 0) != (b.size < 0)) r.negate();
    return r;
  }

  friend FixedInteger operator+(IntegerView a, IntegerView b) {
    if (a.count() <= 1 && b.count() <= 1) return FixedInteger(small(a) + small(b));
    if (a.size == 0) return FixedInteger(b);
    if (b.size == 0) return FixedInteger(a);
    FixedInteger r;
    if (a.count() < b.count()) std::swap(a, b);
    int n = a.count();
    const int m = b.count();
    if ((a.size < 0) == (b.size < 0)) {
      r.limbs_[n] = mpn_add(r.limbs_, a.limbs, n, b.limbs, m);
      if (r.limbs_[n] != 0) ++n;
      assert(n <= kCapacity);
      r.size_ = a.size < 0 ? -n : n;
      return r;
    }
    if (n == m) {
      const int order = mpn_cmp(a.limbs, b.limbs, n);
      if (order == 0) return r;
      if (order < 0) std::swap(a, b);
      mpn_sub_n(r.limbs_, a.limbs, b.limbs, n);
    } else {
      mpn_sub(r.limbs_, a.limbs, n, b.limbs, m);
    }
    r.size_ = n;
    r.trim();
    if (a.size < 0) r.negate();
    return r;
  }

  friend FixedInteger operator-(IntegerView a, IntegerView b) { return a + IntegerView{b.limbs, -b.size}; }
  friend FixedInteger operator-(FixedInteger a) {
    a.negate();
    return a;
  }

 private:
  /// Up to this many limbs a call of GMP costs more than it saves.
  static constexpr int kShort = 4;

  // A loop, because few limbs are the rule.
  void copy(IntegerView x) {
    for (int i = 0; i < x.count(); ++i) limbs_[i] = x.limbs[i];
  }
  // Adds a * b to the limbs from `start`, or sets them where there is nothing yet; returns the carry.
  mp_limb_t multiplyAdd(int start, IntegerView a, mp_limb_t b, bool set) {
    mp_limb_t carry = 0;
    for (int i = 0; i < a.count(); ++i) {
      const auto sum = static_cast<unsigned __int128>(a.limbs[i]) * b + carry + (set ? 0 : limbs_[start + i]);
      limbs_[start + i] = static_cast<mp_limb_t>(sum);
      carry = static_cast<mp_limb_t>(sum >> 64);
    }
    return carry;
  }
  static __int128 small(IntegerView x) {
    return x.size == 0 ? 0 : x.size > 0 ? static_cast<__int128>(x.limbs[0]) : -static_cast<__int128>(x.limbs[0]);
  }
  void trim() {
    while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
  }

  int size_ = 0;
  mp_limb_t limbs_[kCapacity];  // NOLINT: only the first |size_| are set
};

/// The widest grid on which FixedInteger holds every value of the predicates.
inline constexpr int kWidestFixedGrid = (64 * (FixedInteger::kCapacity - 2) - 28) / 26 - 1;

}  // namespace footfall::detail
