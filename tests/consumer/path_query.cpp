// Two places, the way from one to the other, and what is in the way where there is none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <footfall/agent.hpp>
#include <footfall/path.hpp>
#include <footfall/report.hpp>
#include <footfall/run.hpp>
#include <memory>

using namespace footfall;

namespace {

/// A floor of 4 m x 4 m, and beside it another one that lies 0.5 m higher.
std::shared_ptr<const Environment> twoFloors() {
  auto level = std::make_shared<Environment>();
  level->vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 0, 0.5}, {8, 0, 0.5}, {8, 4, 0.5}, {4, 4, 0.5}};
  level->triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  return level;
}

}  // namespace

int main() {
  const std::shared_ptr<const Environment> level = twoFloors();
  const Agent agent{.maxSlope = 45, .height = 1.8};
  const Pipeline pipeline = pipelineFor(*level, agent);
  RunContext context;
  const RunResult run = runPipeline(level, pipeline, context);
  const PathFinder finder(run.mesh);

  const PathResult path = finder.find({1, 1, 0}, {1, 3, 0}, placeReach(pipeline));
  std::printf("%s", formatPath(path, level->up).c_str());
  if (!path.reached() || std::fabs(path.length - 2) > 1e-12) return 1;

  PathResult none = finder.find({1, 1, 0}, {7, 1, 0.5}, placeReach(pipeline));
  const SeparationFinder separations(finder, level, agentHeight(pipeline, level->metresPerUnit));
  addSeparation(none, separations);
  std::printf("%s\n", formatFailure(none, level->up).c_str());
  if (none.status != PathStatus::NotConnected || !none.separation) return 1;
  const BorderLink& step = none.separation->barrier();
  return step.kind == LinkKind::Open && step.gap == 0 && step.rise == 0.5 ? 0 : 1;
}
