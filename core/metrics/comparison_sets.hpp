// The difference of two surfaces as sets of points in space, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/metrics/comparison_cover.hpp"
#include "core/metrics/comparison_surface.hpp"

namespace footfall::comparison {

struct Areas {
  double surface = 0;  ///< in space
  double plan = 0;     ///< seen from above
};

struct SetDifference {
  /// By CoverPart: what is only in A, only in B and in both. Whether there is anything is exact; areas are correct to
  /// 14 digits.
  std::array<bool, 3> hasArea{};
  std::array<Areas, 3> areas;
  /// Of the triangles of A and of B.
  std::array<std::vector<Areas>, 2> triangleAreas;
  /// For each triangle whether it is known to lie in the other set. Others may as well.
  std::array<std::vector<char>, 2> covered;
};

/// Surfaces have common area only where triangles lie in exactly one plane, so each plane is looked at by itself.
SetDifference subtractSets(const ComparedSurfaces& surfaces, RunContext& context);

}  // namespace footfall::comparison
