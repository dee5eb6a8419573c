// The edges of boxes, for overlays.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::ui {

/// The twelve edges of a box along the axes.
inline std::vector<std::array<Vec3, 2>> edgesOfBox(const Vec3& lower, const Vec3& upper) {
  std::vector<std::array<Vec3, 2>> edges;
  const auto corner = [&](unsigned i) {
    return Vec3{(i & 1U) != 0 ? upper.x : lower.x, (i & 2U) != 0 ? upper.y : lower.y,
                (i & 4U) != 0 ? upper.z : lower.z};
  };
  for (unsigned i = 0; i < 8; ++i)
    for (const unsigned bit : {1U, 2U, 4U})
      if ((i & bit) == 0) edges.push_back({corner(i), corner(i | bit)});
  return edges;
}

}  // namespace footfall::ui
