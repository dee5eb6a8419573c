// SPDX-License-Identifier: GPL-3.0-or-later
#include "lengths.hpp"

namespace footfall::samples {

namespace {

constexpr std::int64_t kOne = std::int64_t{1} << 30;
constexpr std::int64_t kTwoPi = 6746518852;  // 2 pi * 2^30

/// Sine in the first quarter by its Taylor series in fixed point; far more digits than a unit of length needs.
std::int64_t sineOfFirstQuarter(int angle) {
  if (angle == kQuarterTurn) return kOne;
  const std::int64_t x = angle * kTwoPi / kTurn;
  const std::int64_t square = (x * x) / kOne;
  std::int64_t term = x;
  std::int64_t sum = x;
  for (int k = 2; k <= 14; k += 2) {
    term = -(term * square / kOne) / (k * (k + 1));
    sum += term;
  }
  return sum;
}

std::int64_t sine(int angle) {
  const int wrapped = ((angle % kTurn) + kTurn) % kTurn;
  const int rest = wrapped % kQuarterTurn;
  switch (wrapped / kQuarterTurn) {
    case 0:
      return sineOfFirstQuarter(rest);
    case 1:
      return sineOfFirstQuarter(kQuarterTurn - rest);
    case 2:
      return -sineOfFirstQuarter(rest);
    default:
      return -sineOfFirstQuarter(kQuarterTurn - rest);
  }
}

}  // namespace

Direction direction(int angle) { return {sine(angle + kQuarterTurn), sine(angle)}; }

int scaled(int length, std::int64_t factor) {
  const std::int64_t product = length * factor;
  const std::int64_t half = kOne / 2;
  return static_cast<int>(product >= 0 ? (product + half) / kOne : -((-product + half) / kOne));
}

int Random::between(int lowest, int highest) {
  state_ ^= state_ >> 12;
  state_ ^= state_ << 25;
  state_ ^= state_ >> 27;
  const std::uint64_t bits = (state_ * 2685821657736338717ULL) >> 32;
  return lowest + static_cast<int>(bits % static_cast<std::uint64_t>(highest - lowest + 1));
}

}  // namespace footfall::samples
