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

/// What a filter may take from earlier runs or the given state, and whether it should leave something for later ones.
/// Never changes the result.
struct Recall {
  /// What the same filter of the same pipeline gave, with other parameters or for the environment that this one is an
  /// edit of; or null.
  StatePtr before;
  bool keep = false;  ///< whether to remember what later runs can copy
  /// Nobody needs the given state after the filter: it may take the state's mesh and change it.
  bool isLast = false;
  /// For a filter that gives a mesh layers and changes nothing else: what else can be done with the mesh at the same
  /// time. Called once, with a state that has the mesh, and its edges. May be null.
  std::function<void(const WalkableState&, const Adjacency&)> meanwhile = nullptr;
};

}  // namespace footfall::detail
