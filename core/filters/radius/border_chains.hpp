// The border of a surface as straight edges, one behind the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/filters/radius/border_pieces.hpp"

namespace footfall::detail {

/// Border pieces of one kind, one behind the other, that are one straight edge to within a few units.
struct BorderChain {
  std::vector<Index> sides;
  bool isLedge = false;
  bool endsInside = false;  ///< its last side ends where another kind begins
  PlanVector begin, end;
  PlanVector along;      ///< a unit vector
  double slack = 0;      ///< "m" (core/filters/radius/margins.hpp)
  bool isShort = false;  ///< a mere place
  Index before = -1, behind = -1;
  [[nodiscard]] double size() const { return isShort ? 0 : length(end - begin); }
};

/// The place where the surface continues in several ways behind a border, because floors overlap there, is a chain of
/// its own with nothing before and behind it, and none has one behind.
///
/// The chains, in an order that depends on the surface alone. `pieces` are all of its border, by side and then along
/// it.
std::vector<BorderChain> findBorderChains(const MarginSurface& surface, const std::vector<BorderPiece>& pieces);

/// MarginSurface::fanBehind() of a chain; where it ends inside of a side, that side alone.
void fanBehind(const MarginSurface& surface, const BorderChain& chain, std::vector<Index>& fan);

}  // namespace footfall::detail
