// A state between filters as a handle, and what a run may copy from earlier ones.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace footfall::detail {

struct Adjacency;      // core/mesh/adjacency.hpp
struct WalkableState;  // core/assembly/walkable_state.hpp
/// Immutable: a filter makes a new state, so that results can be cached and shared between threads.
using StatePtr = std::shared_ptr<const WalkableState>;

/// The parts of earlier runs or of the given state that a filter may reuse, and whether it should leave data for later
/// runs. Never changes the result.
struct Recall {
  /// The result of the same filter of the same pipeline, with other parameters or for the environment that this one is
  /// an edit of; or null.
  StatePtr before;
  bool keep = false;  ///< true: keep the data that later runs can copy
  /// The given state is not needed after the filter, which may take the state's mesh and change it.
  bool isLast = false;
  /// False: no later filter reads triangles that are no floors, and the result may leave them out.
  bool needsObstacles = true;
  /// Work that can be done on the mesh while a filter adds layers to it and changes nothing else. Called once, with a
  /// state that has the mesh, and its edges. May be null.
  std::function<void(const WalkableState&, const Adjacency&)> meanwhile = nullptr;
};

}  // namespace footfall::detail
