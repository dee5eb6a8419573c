// The border of a surface as straight edges, one behind the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/filters/radius/margin_surface.hpp"

namespace footfall::detail {

/// Border sides, one behind the other, that are one straight edge to within a few units.
struct BorderChain {
  std::vector<Index> sides;
  PlanVector begin, end;
  PlanVector along;      ///< a unit vector
  double slack = 0;      ///< "m" (core/filters/radius/margins.hpp)
  bool isShort = false;  ///< a mere place
  Index before = -1, behind = -1;
  [[nodiscard]] double size() const { return isShort ? 0 : length(end - begin); }
};

/// In an order that depends on the surface alone.
std::vector<BorderChain> findBorderChains(const MarginSurface& surface);

}  // namespace footfall::detail
