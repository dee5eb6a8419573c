// Running one filter. The state between filters is opaque here: exact geometry stays inside the filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/environment/environment.hpp"
#include "core/environment/navigation_mesh.hpp"
#include "core/exact/exact_fallbacks.hpp"
#include "core/filters/descriptor.hpp"
#include "core/pipeline/run_context.hpp"
#include "core/text.hpp"

namespace footfall {

struct WalkableState;  // core/filters/walkable_state.hpp
/// Immutable: a filter makes a new state, so that results can be cached and shared between threads.
using StatePtr = std::shared_ptr<const WalkableState>;

struct StateSummary {
  std::uint64_t triangles = 0;  ///< walkable triangles
  double area = 0;              ///< 3D surface area of the walkable triangles, rounded
  std::uint64_t rejected = 0;   ///< triangles of the environment that are obstacles only
  std::uint32_t layers = 0;
  std::uint64_t connections = 0;
  std::uint64_t obstacleEdges = 0;
};

/// What a filter says about its own work beside the result, for the user (e.g. "3 vertices merged").
struct FilterOutcome {
  StatePtr state;
  Text note;  ///< may be empty
  ExactFallbacks fallbacks;
};

/// What a filter may take from earlier runs, and whether it should leave something for later ones. Never changes the
/// result.
struct Recall {
  /// What the same filter of the same pipeline gave, with other parameters or for the environment that this one is an
  /// edit of; or null.
  StatePtr before;
  bool keep = false;  ///< later runs may ask: remember what they can take over
};

/// The state before the first filter: all non-degenerate triangles that face up are walkable.
StatePtr makeInitialState(std::shared_ptr<const Environment> environment, RunContext& context,
                          const Recall& recall = {});

/// Runs one filter. `values` has one number for each parameter of the descriptor (booleans 0 or 1), already
/// validated against it; a strategy or Collapse is the runner's. Throws Cancelled or std::bad_alloc; the given state is
/// never changed. The result does not depend on the number of threads.
FilterOutcome applyFilter(const FilterDescriptor& filter, const std::vector<double>& values, const StatePtr& state,
                          RunContext& context, const Recall& recall = {});

StateSummary summarize(const WalkableState& state);

/// The product: conforming, joined at contacts, rounded and repaired, vertices split along obstacle edges
/// (design sections 3 and 6).
std::shared_ptr<const NavigationMesh> makeNavigationMesh(const StatePtr& state, RunContext& context);

/// A quick picture of a state for display while a run goes on: rounded, not repaired.
std::shared_ptr<const NavigationMesh> makePreviewMesh(const WalkableState& state);

}  // namespace footfall
