// What obstacles leave on one floor triangle: segments with winding numbers, and walls.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/exact/plan_kernel.hpp"

namespace footfall {

/// A piece of a region's outline or of a wall's trace.
struct CutSegment {
  Index from = -1, to = -1;   ///< points of the FaceCuts
  Index line = -1;            ///< line of the FaceCuts
  std::int8_t direction = 1;  ///< +1: from -> to runs along the line
  int winding = 0;            ///< regions on the left minus regions on the right
  bool wall = false;
};

/// Value type: everything that triangulating the face needs, in ids of one generation.
struct FaceCuts {
  bool removed = false;        ///< one obstacle covers the whole face
  std::uint8_t edgeWalls = 0;  ///< bit k: a wall stands along the whole edge from corner k to k + 1
  std::vector<PlanPoint> points;
  std::vector<std::uint8_t> borders;  ///< for each point, bit k: known to lie on the face's edge k
  std::vector<PlanLine> lines;
  std::vector<CutSegment> segments;

  [[nodiscard]] bool empty() const { return !removed && edgeWalls == 0 && segments.empty(); }
};

}  // namespace footfall
