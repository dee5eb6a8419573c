// Hilbert curves in the plane and in space: orders in which neighbours mostly lie near each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace footfall::detail {

struct HilbertStep {
  std::uint8_t place = 0;  ///< among the 256 squares
  std::uint8_t turn = 0;   ///< below the square
};

/// Four levels of the curve in one step. Below the squares of a level the curve is turned in one of four ways: x and y
/// swapped (1), both counted from the other end (2).
struct HilbertTurns {
  std::array<std::array<HilbertStep, 256>, 4> steps{};  ///< [turn][four bits of x, then of y]

  constexpr HilbertTurns() {
    for (unsigned turn = 0; turn < 4; ++turn)
      for (unsigned bits = 0; bits < 256; ++bits) {
        unsigned now = turn, place = 0;
        for (unsigned level = 4; level-- > 0;) {
          const unsigned x = (bits >> (4 + level) & 1U) ^ (now >> 1U), y = (bits >> level & 1U) ^ (now >> 1U);
          const unsigned rx = (now & 1U) != 0 ? y : x, ry = (now & 1U) != 0 ? x : y;
          place = place << 2U | ((3 * rx) ^ ry);
          if (ry == 0) now ^= rx == 1 ? 3U : 1U;
        }
        steps[turn][bits] = {static_cast<std::uint8_t>(place), static_cast<std::uint8_t>(now)};
      }
  }
};

/// The place of a square along a Hilbert curve over 2^16 x 2^16 squares.
inline std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
  static constexpr HilbertTurns kTurns;
  std::uint64_t index = 0;
  std::size_t turn = 0;
  for (unsigned shift = 16; shift > 0;) {
    shift -= 4;
    const HilbertStep step = kTurns.steps[turn][(x >> shift & 15U) << 4U | (y >> shift & 15U)];
    index = index << 8U | step.place;
    turn = step.turn;
  }
  return index;
}

/// Bits of each coordinate of hilbertIndex3().
inline constexpr int kHilbertBits3 = 20;

/// The place of a cube along a Hilbert curve over 2^20 x 2^20 x 2^20 cubes (Skilling, Programming the Hilbert curve,
/// 2004).
inline std::uint64_t hilbertIndex3(std::array<std::uint32_t, 3> place) {
  constexpr std::uint32_t kTop = 1U << (kHilbertBits3 - 1);
  for (std::uint32_t q = kTop; q > 1; q >>= 1) {
    const std::uint32_t below = q - 1;
    for (std::uint32_t& x : place) {
      if ((x & q) != 0) {
        place[0] ^= below;
      } else {
        const std::uint32_t change = (place[0] ^ x) & below;
        place[0] ^= change;
        x ^= change;
      }
    }
  }
  place[1] ^= place[0];
  place[2] ^= place[1];
  std::uint32_t change = 0;
  for (std::uint32_t q = kTop; q > 1; q >>= 1)
    if ((place[2] & q) != 0) change ^= q - 1;
  std::uint64_t index = 0;
  for (int bit = kHilbertBits3 - 1; bit >= 0; --bit)
    for (const std::uint32_t x : place) index = index << 1 | (((x ^ change) >> bit) & 1U);
  return index;
}

}  // namespace footfall::detail
