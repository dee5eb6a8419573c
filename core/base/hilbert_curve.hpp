// Orders of points in a plane and in space in which neighbours mostly lie near each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace footfall::detail {

/// The place of a cell along a Hilbert curve over 2^16 x 2^16 cells.
inline std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t s = 1U << 15; s > 0; s >>= 1) {
    const std::uint32_t rx = (x & s) != 0 ? 1 : 0, ry = (y & s) != 0 ? 1 : 0;
    index += static_cast<std::uint64_t>(s) * s * ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = 65535 - x;
        y = 65535 - y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

/// Bits of each coordinate of hilbertIndex3().
inline constexpr int kHilbertBits3 = 20;

/// The place of a cell along a Hilbert curve over 2^20 x 2^20 x 2^20 cells (Skilling, Programming the Hilbert curve,
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
