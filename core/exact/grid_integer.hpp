// Coordinates as integers on the common grid.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/exact/fixed_integer.hpp"
#include "core/exact/grid.hpp"

namespace footfall::detail {

/// |x| = digits * 2^shift in units of 2^gridExponent, for an x on that grid; shift >= 0.
struct GridDigits {
  std::uint64_t digits;
  int shift;

  GridDigits(double x, int gridExponent) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int exponent = static_cast<int>(bits >> 52 & 0x7FF);
    digits = bits & 0xFFFFFFFFFFFFFULL;
    if (exponent != 0) digits |= 1ULL << 52;
    shift = digits == 0 ? 0 : std::max(exponent, 1) - 1075 - gridExponent;
    digits >>= std::max(-shift, 0);  // zeros: x is on the grid
    shift = std::max(shift, 0);
  }
};

/// An x on the grid as an integer.
template <class T>
T gridInteger(double x, int gridExponent);

template <>
inline __int128 gridInteger<__int128>(double x, int gridExponent) {
  const GridDigits g(x, gridExponent);
  const auto size = static_cast<__int128>(g.digits) << g.shift;
  return x < 0 ? -size : size;
}

template <>
inline FixedInteger gridInteger<FixedInteger>(double x, int gridExponent) {
  const GridDigits g(x, gridExponent);
  FixedInteger r = FixedInteger::shifted(g.digits, g.shift);
  if (x < 0) r.negate();
  return r;
}

template <>
inline mpz_class gridInteger<mpz_class>(double x, int gridExponent) {
  const GridDigits g(x, gridExponent);
  mpz_class r(static_cast<unsigned long>(g.digits));
  r <<= static_cast<mp_bitcnt_t>(g.shift);
  return x < 0 ? mpz_class(-r) : r;
}

/// Up to this Grid::width() coordinates are subtracted as 128-bit integers.
inline constexpr int kNarrowGrid = 125;

/// x - y as an integer; `narrow` is true where the grid is no wider than kNarrowGrid.
template <class T>
T gridDifference(double x, double y, int gridExponent, bool /*narrow*/) {
  return gridInteger<T>(x, gridExponent) - gridInteger<T>(y, gridExponent);
}

/// Apart, as its numbers would make the frame of every caller larger.
[[gnu::noinline]] inline FixedInteger wideGridDifference(double x, double y, int gridExponent) {
  return gridInteger<FixedInteger>(x, gridExponent) - gridInteger<FixedInteger>(y, gridExponent);
}

template <>
inline FixedInteger gridDifference<FixedInteger>(double x, double y, int gridExponent, bool narrow) {
  if (narrow) return FixedInteger(gridInteger<__int128>(x, gridExponent) - gridInteger<__int128>(y, gridExponent));
  return wideGridDifference(x, y, gridExponent);
}

}  // namespace footfall::detail
