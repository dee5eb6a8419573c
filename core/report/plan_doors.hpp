// Finds the doors of a building for floor plans; IFC files mark them by their class.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/poll.hpp"
#include "core/report/plan_walls.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// A rectangle in the plan, as wide as the door and as deep as it is in its wall, and the heights that it stands
/// between. In the environment's units.
struct PlanDoor {
  std::array<PlanPlace, 4> corners{};  ///< the first two are one long side
  double lower = 0, upper = 0;
};

/// The doors of the file that an environment was made of, though they are open and so are not in it: what hangs
/// together or lies beside each other among the triangles of one part of a door's class is one door. Its rectangle is
/// the smallest round those of its triangles that are half as high as the door (not handles) that is parallel to one of
/// their edges. Rounded; for pictures only. Empty where the file names no classes, or is not held by anyone any more
/// (EnvironmentEdit::base). `poll` may throw.
std::vector<PlanDoor> findDoors(const Environment& environment, Poll poll = {});

}  // namespace footfall::detail
