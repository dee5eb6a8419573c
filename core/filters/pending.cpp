// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/filter_registry.hpp"
namespace footfall {
FilterOutcome applyDuplication(const StatePtr& state, double, RunContext&) { return {state, {}, {}}; }
FilterOutcome applyArea(const StatePtr& state, double, RunContext&) { return {state, {}, {}}; }
FilterOutcome applySimplification(const StatePtr& state, bool, double, RunContext&) { return {state, {}, {}}; }
FilterOutcome applyLayerSubdivision(const StatePtr& state, RunContext&) { return {state, {}, {}}; }
FilterOutcome applyRounding(const StatePtr& state, RunContext&) { return {state, {}, {}}; }
}  // namespace footfall
