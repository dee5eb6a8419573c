// Doorways of a level, as they are modelled most often: a lintel whose ends stand on jambs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// A doorway, in the environment's units.
struct Doorway {
  double width = 0, height = 0;
};

/// Finds level rectangles that face down, are at most a metre deep, and have at both short sides the top of an upright
/// triangle, which is as high as the doorway. Those from 0.4 to 4 m wide and at least 1.4 m high count, which leaves
/// out most windows. Two triangles make a rectangle, with the vertices of the jambs. Not every level has such doorways,
/// and not every such rectangle is one. Rounded. The time is proportional to the number of triangles, plus sorting the
/// walls.
std::vector<Doorway> findDoorways(const Environment& environment, const Poll& poll = {});

}  // namespace footfall::detail
