// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/walkable_area.hpp"

#include <memory>

#include "footfall/run.hpp"

namespace footfall {

NavigationMesh walkableArea(const Environment& level, const Agent& agent, RunContext* context, int threads) {
  checkEnvironment(level);
  RunContext ownContext;
  // Lent: the run is over before the caller goes on.
  const std::shared_ptr<const Environment> lent(&level, [](const Environment*) {});
  return *runPipeline(lent, pipelineFor(level, agent), context != nullptr ? *context : ownContext, nullptr, threads)
              .mesh;
}

}  // namespace footfall
