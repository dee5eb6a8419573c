// Finds which triangles of a walkable mesh lie above one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/assembly/mesh_relation.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// All pairs of triangles whose insides overlap in the plan, exactly; each once, in no particular order. Empty when
/// there are more than `most`. `tested` (may be null) gets the number of pairs that were
/// tested exactly, and of exact decisions about outlines.
std::optional<std::vector<std::array<Index, 2>>> findPlanOverlaps(const PlanKernel& kernel, const WalkableMesh& mesh,
                                                                  const Adjacency& topology, std::size_t most,
                                                                  RunContext& context, ExactFallbacks& fallbacks,
                                                                  std::size_t* tested = nullptr);

/// Finds the overlaps when the pairs of an earlier mesh are known.
std::vector<std::array<Index, 2>> updatePlanOverlaps(const std::vector<std::array<Index, 2>>& before,
                                                     const MeshRelation& relation, const PlanKernel& kernel,
                                                     const WalkableMesh& mesh, RunContext& context,
                                                     ExactFallbacks& fallbacks);

}  // namespace footfall::detail
