// How far below a point its walkable place may lie, for an agent.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pipeline/pipeline.hpp"

namespace footfall {

/// Just below the largest clearance that an enabled VerticalClearanceFilter asks for: so far above a walkable place
/// there is no obstacle, and a point on an obstacle never means a floor beneath it (PathFinder::find). Infinite when
/// there is no such filter.
double placeReach(const Pipeline& pipeline);

}  // namespace footfall
