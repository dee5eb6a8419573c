// Indices of mesh elements, and boxes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "footfall/geometry.hpp"

namespace footfall::detail {

/// The number of a mesh element; -1 often stands for none.
using Index = std::int32_t;

/// The corner or edge of a triangle that follows `k`, and the one that precedes it.
constexpr int next(int k) { return k == 2 ? 0 : k + 1; }
constexpr int previous(int k) { return k == 0 ? 2 : k - 1; }

/// A closed box whose sides are parallel to the axes.
struct Box {
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
};

/// Returns whether two boxes have a point in common.
[[nodiscard]] inline bool overlap(const Box& a, const Box& b) {
  return a.lower[0] <= b.upper[0] && a.upper[0] >= b.lower[0] && a.lower[1] <= b.upper[1] && a.upper[1] >= b.lower[1] &&
         a.lower[2] <= b.upper[2] && a.upper[2] >= b.lower[2];
}

}  // namespace footfall::detail
