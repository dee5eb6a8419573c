// Taking regions away: they are obstacles still, and stay away when floors are cut anew.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/assembly/recall.hpp"
#include "core/assembly/walkable_state.hpp"
#include "footfall/run_context.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The mesh without the triangles that lie in `dropped`, whose outlines are among the cuts that the mesh was made from.
std::shared_ptr<const WalkableMesh> withoutDropped(const PlanKernel& kernel, const WalkableMesh& mesh,
                                                   const WalkableMesh& dropped, RunContext& context,
                                                   ExactFallbacks& fallbacks);

/// The result of the same filter, which takes regions away, for another state.
using SameFilter = std::function<StatePtr(const StatePtr& state)>;

/// The regions of a state's mesh that stay.
struct RegionChoice {
  const Adjacency& topology;         ///< adjacency of the mesh
  const std::vector<Index>& region;  ///< region of each triangle (findRegions())
  const std::vector<char>& keep;     ///< one flag per region
  bool isLast = false;               ///< the state is not needed after the filter (Recall::isLast)
};

/// The state without the other regions. Links and drops stay where both of their sides do. `sameOf` is called with the
/// state before a simplification when that is needed to find which floors are left.
std::shared_ptr<const WalkableState> withRegions(const WalkableState& state, const RegionChoice& choice,
                                                 const SameFilter& sameOf, RunContext& context,
                                                 ExactFallbacks& fallbacks);

/// "2 of 5 regions removed", for people.
Text regionsRemoved(std::int64_t removed, std::int64_t all);

}  // namespace footfall::detail
