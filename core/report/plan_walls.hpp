// Cuts the obstacles on and around the floors of a plan, like the walls in an architect's drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

using PlanPlace = std::array<double, 2>;  ///< x and y, in the environment's units
using PlanLineString = std::vector<PlanPlace>;

/// A wall with a thickness, as it is cut for the floors about as high as `level`.
struct PlanSolid {
  std::vector<PlanLineString> lines;  ///< its outline, counter-clockwise, and the hollows in it
  double level = 0;
};

/// Closed lines have no last point that repeats the first.
struct PlanWalls {
  std::vector<PlanSolid> solids;
  std::vector<PlanLineString> closedLines;  ///< surfaces round a space, such as the walls of a level seen from inside
  std::vector<PlanLineString> openLines;    ///< surfaces without a thickness or with open ends
};

struct WallCut {
  double cutHeight = 1.1;  ///< height above a floor; all lengths in the environment's units
  double tolerance = 0.5;  ///< floors whose heights differ by less are cut together
  double margin = 0.5;     ///< distance from a floor within which walls are drawn, in the plan
};

/// Cuts the environment at a height above the floors `triangles` of `mesh`: in one horizontal plane for all that lie
/// about as high, in several planes for slopes and stairs. Only what comes near a floor that belongs to the plane is
/// given. Rounded; for pictures only. `poll` may throw.
PlanWalls cutWalls(const Environment& environment, const NavigationMesh& mesh, std::span<const std::uint32_t> triangles,
                   const WallCut& cut, Poll poll = {});

/// True when a place is inside a solid.
bool contains(const PlanSolid& solid, const PlanPlace& place);

}  // namespace footfall::detail
