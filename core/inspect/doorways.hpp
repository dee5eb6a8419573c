// Doorways of a level, as they are modelled most often: a lintel whose ends stand on jambs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// In the environment's units.
struct Doorway {
  double width = 0, height = 0;
};

/// Of each level rectangle that faces down, is at most a metre deep, and has at both of its short sides the top of an
/// upright triangle, which is as high as the doorway: those from 0.4 to 4 m wide and 1.4 m high, which leaves out most
/// windows. Two triangles make a rectangle, with the vertices of the jambs. Not every level has its doorways like that,
/// and what is found need not be one; rounded. Takes time in proportion to the triangles, and a sorting of the walls.
std::vector<Doorway> findDoorways(const Environment& environment, const Poll& poll = {});

}  // namespace footfall::detail
