// The area that two sets of polygons of one plane cover, alone and together, decided exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines are cancelled before anything is arranged: every edge carries how much the two winding numbers change
// across it; edges between triangles of one set add up to nothing, on whole lines, whatever the triangulation. What
// remains is cut where it crosses, and a ray from each piece counts the windings on its two sides. All decisions are
// on integers; doubles only settle those that are clear.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"

namespace footfall::detail::comparison {

/// A point of the plane on a grid of integers.
struct CoverPoint {
  mpz_class x, y;
};

/// Part of the outline of a polygon of set 0 or 1, which lies to the left of it.
struct CoverEdge {
  std::uint32_t from, to;
  std::uint32_t set;
};

/// The parts of the plane that only set 0, only set 1 and both cover.
enum CoverPart : std::uint8_t { kOnlyFirst, kOnlySecond, kBoth };

/// An end of a piece; `point` is its index when it is one of the given points, else kNoPoint. Coordinates are rounded,
/// in units of the grid.
struct CoverCorner {
  static constexpr std::uint32_t kNoPoint = 0xFFFFFFFF;
  double x = 0, y = 0;
  std::uint32_t point = kNoPoint;
};

/// A piece of the border of a part, which lies above it (or, where it is vertical, to the left of it) or below; from
/// its lower end by x, then y. Pieces do not cross each other.
struct CoverPiece {
  CoverPart part;
  bool isBelowPart;
  CoverCorner from, to;
};

struct CoverResult {
  std::array<bool, 3> hasArea{};  ///< indexed by CoverPart, exact
  /// Twice the areas in squared units of the grid. Computed with so many digits that the relative error is below
  /// 2^-60, however small they are.
  std::array<mpf_class, 3> twiceArea;
};

/// Each polygon's edges must close around it counter-clockwise; polygons may overlap and touch as they like. Points
/// may be equal; where equal ones have one index it is faster. `poll` may throw. `borders` (may be null) receives the
/// borders of the parts that are only in one set, complete and exactly chosen.
CoverResult coverAreas(const std::vector<CoverPoint>& points, const std::vector<CoverEdge>& edges, Poll poll,
                       std::vector<CoverPiece>* borders = nullptr);

}  // namespace footfall::detail::comparison
