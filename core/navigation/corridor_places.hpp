// Places along an edge of the corridor map, for drawings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "footfall/corridor_map.hpp"

namespace footfall::detail {

/// Places along an edge, its ends included; a parabola gets some between them.
std::vector<Vec3> placesAlong(const CorridorMap& map, const CorridorEdge& edge);

}  // namespace footfall::detail
