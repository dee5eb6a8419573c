// Doors and other openings of a level, by what lies over them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// The free heights under lintels, ascending, in the environment's units: one for each level triangle that faces down,
/// is longer than it is wide, at most a third as wide as what is free under its middle is high, and at most twice as
/// long. Two make an opening that has a rectangle over it. Rounded; builds a tree where there is any such triangle.
std::vector<double> measureOpenings(const Environment& environment, const Poll& poll = {});

}  // namespace footfall::detail
