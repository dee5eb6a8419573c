// How high an agent is, and how far below a point its walkable place may lie for it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "footfall/pipeline.hpp"

namespace footfall::detail {

/// Just below the largest clearance that an enabled VerticalClearanceFilter asks for: so far above a walkable place
/// there is no obstacle, and a point on an obstacle never means a floor beneath it (PathFinder::find). Infinite when
/// there is no such filter.
double placeReach(const Pipeline& pipeline);

/// The height of the agent that a pipeline is for: the largest clearance that an enabled VerticalClearanceFilter asks
/// for, or 2 metres, in the environment's units.
double agentHeight(const Pipeline& pipeline, double metresPerUnit);

}  // namespace footfall::detail
