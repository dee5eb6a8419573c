// The clearance filter for some floors of a part of an environment; its other floors are not computed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/filters/apply_filter.hpp"

namespace footfall::detail {

/// applyVerticalClearance(), but only floors that are chosen (one for each face) are cut, and only they are in the
/// mesh. For them the result is the same, when all that stands in the clearance above them is there. The others remain
/// floors.
FilterOutcome applyClearanceToChosen(const StatePtr& state, double height, const std::vector<char>& chosen,
                                     RunContext& context);

}  // namespace footfall::detail
