// Widths of passages on a floor plan: the corridor map as lines, and bottlenecks as dimension lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/report/plan_layout.hpp"
#include "core/report/plan_sheet.hpp"
#include "footfall/corridor_map.hpp"

namespace footfall::detail {

struct PlanCorridors {
  CorridorMap map;
  bool hasLines = false;            ///< the map is drawn
  std::vector<std::size_t> narrow;  ///< bottlenecks of the map that are drawn
};

/// The parts of the map that a page shows.
struct PlanCorridorContents {
  bool lines = false, bottlenecks = false;
};

/// Draws what of the map lies on triangles with `isHere`. Dimension lines go from border to border, with a tick at
/// either end; their words, the widths in metres, are added to `words`.
PlanCorridorContents drawCorridors(const PlanCorridors& corridors, const NavigationMesh& mesh,
                                   const std::vector<char>& isHere, double metresPerUnit, const PlanLayout& layout,
                                   const Rgb& lineColour, const Rgb& dimensionColour, std::vector<SheetShape>& drawing,
                                   std::vector<SheetText>& words);

/// A line from `a` to `b` with oblique ticks at its ends.
void addDimension(std::vector<SheetShape>& drawing, SheetPoint a, SheetPoint b, const Rgb& colour);

}  // namespace footfall::detail
