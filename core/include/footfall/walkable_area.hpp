// The walkable area of an environment for an agent, in one call.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "footfall/agent.hpp"
#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

/// The exact walkable area of `level` for `agent`, split into layers, with vertices rounded to doubles. It is what
/// runPipeline() gives for pipelineFor(level, agent); use that for statistics, a cache or filters of your own.
///
/// `context` (may be null) reports progress and cancels, from any thread. `threads` limits the worker threads, 0: as
/// many as the machine has; the result does not depend on it. Calls from several threads at the same time are fine.
///
/// Throws InputError (checkEnvironment(), an agent out of range), Cancelled, or RunError when memory runs out.
NavigationMesh walkableArea(const Environment& level, const Agent& agent = {}, RunContext* context = nullptr,
                            int threads = 0);

}  // namespace footfall
