// Running one filter. The state between filters is opaque here: exact geometry stays inside the filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/assembly/recall.hpp"
#include "core/exact/grid.hpp"
#include "footfall/environment.hpp"
#include "footfall/errors.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"
#include "footfall/statistics.hpp"
#include "footfall/text.hpp"

namespace footfall {
struct FilterDescriptor;
}

namespace footfall::detail {

/// The outcome of a filter beside the result: texts for the user (e.g. "3 vertices merged").
struct FilterOutcome {
  StatePtr state;
  Text note;  ///< may be empty
  ExactFallbacks fallbacks;
};

/// Thrown when one of a step's values needs something that the environment does not have.
struct ValueError : InputError {
  ValueError(std::size_t index, Text text) : InputError(std::move(text)), value(index) {}
  std::size_t value;  ///< number of the value within its step
};

/// The state before the first filter: all non-degenerate triangles that face up are walkable. `grid`: that of a whole
/// of which the environment is a part, so that the same is computed as in the whole.
StatePtr makeInitialState(std::shared_ptr<const Environment> environment, RunContext& context,
                          const Recall& recall = {}, const Grid& grid = {});

/// Runs one filter. `values` has one number for each parameter of the descriptor (booleans 0 or 1), already
/// validated against it; a strategy or Collapse is the runner's. Throws Cancelled, InputError or std::bad_alloc; the
/// given state is never changed. The result does not depend on the number of threads.
FilterOutcome applyFilter(const FilterDescriptor& filter, const std::vector<double>& values, const StatePtr& state,
                          RunContext& context, const Recall& recall = {});

StateSummary summarize(const WalkableState& state);

/// The product: conforming, joined at contacts, rounded and repaired, vertices split along obstacle edges
/// (docs/explanation/model.md, Exact decisions).
std::shared_ptr<const NavigationMesh> makeNavigationMesh(const StatePtr& state, RunContext& context);

/// A quick picture of a state for display while a run goes on: rounded, not repaired.
std::shared_ptr<const NavigationMesh> makePreviewMesh(const WalkableState& state);

}  // namespace footfall::detail
