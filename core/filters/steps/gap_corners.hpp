// Links at corners of borders that are not needed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/poll.hpp"
#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_linker.hpp"
#include "core/filters/steps/step_memory.hpp"

namespace footfall::detail {

/// Removes the gaps with a corner (GapPiece::corner) whose sides hang together right there: within twice the gap's
/// width (environment units) one gets from one to the other on the mesh, over steps, and over other gaps; of those with
/// a corner, the longer ones come first. So notches and slits between chains of edges get no link across each vertex as
/// well, a corner has one, and nothing comes apart. `poll` may throw to cancel.
void removeNeedlessCorners(std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps,
                           const BorderSplits& splits, double gap, Poll poll);

}  // namespace footfall::detail
