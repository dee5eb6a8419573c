// The filters' own functions. Each is implemented in the file of its name; applyFilter() finds it by descriptor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/filters/face_filter.hpp"

namespace footfall::detail {

FilterOutcome applyDuplication(const StatePtr& state, double distance, RunContext& context);
FilterOutcome applyDegeneracy(const StatePtr& state, RunContext& context);
FaceTest makeSlopeTest(double degrees, double tolerance, const std::shared_ptr<const PlanKernel>& kernel);
FilterOutcome applySlope(const StatePtr& state, double degrees, double tolerance, RunContext& context);
FilterOutcome applyVerticalClearance(const StatePtr& state, double height, const Recall& recall, RunContext& context);
FilterOutcome applyStep(const StatePtr& state, double step, double gap, const Recall& recall, RunContext& context);
FilterOutcome applyRadius(const StatePtr& state, double radius, double ledges, double tolerance, const Recall& recall,
                          RunContext& context);
FilterOutcome applyDrop(const StatePtr& state, double depth, double reach, RunContext& context);
/// `seeds`: the coordinates of places in the file's frame, three each.
FilterOutcome applyReachable(const StatePtr& state, std::span<const double> seeds, RunContext& context);
FilterOutcome applyArea(const StatePtr& state, double minimum, const Recall& recall, RunContext& context);
FilterOutcome applySimplification(const StatePtr& state, bool approximate, double tolerance, const Recall& recall,
                                  RunContext& context);
FilterOutcome applyLayerSubdivision(const StatePtr& state, const Recall& recall, RunContext& context);
FilterOutcome applyRounding(const StatePtr& state, bool repair, RunContext& context);

}  // namespace footfall::detail
