// Links at corners of borders, and short ones, that are not needed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/poll.hpp"
#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_linker.hpp"
#include "core/filters/steps/step_memory.hpp"

namespace footfall::detail {

/// Removes the gaps with a place (GapPiece::corner: at corners, and short ones) whose sides hang together right there:
/// within twice the gap's width (environment units) one gets from one to the other on the mesh, over steps, and over
/// other gaps; of those with a place, the longer ones come first. So notches and slits between chains of edges get no
/// link across each vertex as well, a corner has one, floors that are hardly larger than the gap get as few as join
/// them, and nothing comes apart. Returns how many it removed. `poll` may throw to cancel.
std::size_t removeNeedlessGaps(std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps,
                               const BorderSplits& splits, double gap, Poll poll);

}  // namespace footfall::detail
