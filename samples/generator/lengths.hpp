// Lengths, angles and random numbers that are the same on every machine: integers only.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace footfall::samples {

/// Lengths are whole multiples of 1/64 m, so that every coordinate is a short binary and decimal fraction.
constexpr int kUnitsPerMetre = 64;

/// Metres in source text: `2.5_m`. A length that is not on the grid does not compile.
consteval int operator""_m(long double metres) {
  const long double units = metres * kUnitsPerMetre;
  if (units != static_cast<long double>(static_cast<int>(units))) throw "not a multiple of 1/64 m";
  return static_cast<int>(units);
}
consteval int operator""_m(unsigned long long metres) { return static_cast<int>(metres * kUnitsPerMetre); }

/// Angles count 4096ths of a full turn, counter-clockwise seen from above, from +X.
constexpr int kTurn = 4096;
constexpr int kQuarterTurn = kTurn / 4;

/// Cosine and sine, scaled by 2^30; exact at quarter turns.
struct Direction {
  std::int64_t cos = std::int64_t{1} << 30;
  std::int64_t sin = 0;
};

Direction direction(int angle);

/// length * scaled / 2^30, to the nearest unit.
int scaled(int length, std::int64_t factor);

/// Small generator (xorshift64*), because the distributions of the standard library differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// A number in [lowest, highest].
  int between(int lowest, int highest);
  /// A multiple of `step` away from `lowest`, at most `highest`.
  int between(int lowest, int highest, int step) { return lowest + step * between(0, (highest - lowest) / step); }
  /// True in `percent` of 100 calls.
  bool chance(int percent) { return between(0, 99) < percent; }

 private:
  std::uint64_t state_;
};

}  // namespace footfall::samples
