// The order of vertices in the plan from left to right, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/walkable_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The places of some vertices by x, then by y. Equal places have one number.
struct PlanOrder {
  std::vector<Index> placeOf;   ///< number of each vertex's place; of use for those that were asked for
  std::vector<Index> vertexAt;  ///< one vertex at each place
};

/// `vertices` has no vertex twice. Doubles decide where they can; only vertices whose coordinates may be equal are
/// compared exactly. `decisions` receives the number of exact comparisons. The result does not depend on threads.
PlanOrder findPlanOrder(const std::vector<Index>& vertices, const PlanKernel& kernel, const WalkableMesh& mesh,
                        RunContext& context, ExactFallbacks& fallbacks, std::size_t& decisions);

}  // namespace footfall::detail
