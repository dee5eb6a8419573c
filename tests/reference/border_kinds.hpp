// Finds which parts of a border are walls and which are ledges (docs/explanation/model.md, Walls and ledges): slow,
// obvious, in doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "footfall/environment.hpp"

namespace footfall::reference {

enum class BorderKind { Wall, Ledge, Doubtful };

struct BorderStretch {
  double begin = 0, end = 1;  ///< shares of the edge
  BorderKind kind = BorderKind::Doubtful;
};

/// Divides a border edge, with walkable area on its left. A place is at a wall when the environment reaches over it,
/// strictly between the step and the height above it, straight over it or beside it on the right; on a grid also by a
/// wall within four steps of the grid on the right that leans by no more between these heights. Places that a hair
/// decides are doubtful.
std::vector<BorderStretch> stretchesOf(const Environment& environment, const Vec3& a, const Vec3& b, double step,
                                       double height);

}  // namespace footfall::reference
