// The step filter for the borders of some floors of a part of an environment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/filters/apply_filter.hpp"

namespace footfall::detail {

/// applyStep() restricted to borders of chosen faces. `chosen` has an entry for each source triangle, or is null for
/// all. With `linksGaps` false, gaps are not linked; they are found only for the memory that `recall` may keep.
FilterOutcome applyStepToChosen(const StatePtr& given, double step, double gap, const std::vector<char>* chosen,
                                bool linksGaps, const Recall& recall, RunContext& context);

}  // namespace footfall::detail
