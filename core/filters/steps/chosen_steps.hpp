// The step filter for the borders of some floors of a part of an environment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/filters/filter.hpp"

namespace footfall::detail {

/// applyStep(), but only between borders of faces that are chosen: one for each source triangle, or null for all. With
/// `linksGaps` false, gaps are found for the memory that `recall` may keep, and not linked.
FilterOutcome applyStepToChosen(const StatePtr& given, double step, double gap, const std::vector<char>* chosen,
                                bool linksGaps, const Recall& recall, RunContext& context);

}  // namespace footfall::detail
