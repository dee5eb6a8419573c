// A crate is pushed through a level, and the walkable area follows; then a run is cancelled from another thread.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <footfall/agent.hpp>
#include <footfall/edit.hpp>
#include <footfall/inspect.hpp>
#include <footfall/run.hpp>
#include <memory>
#include <thread>

#include "floor.hpp"

using namespace footfall;

namespace {

/// A wall of a metre's height across the level, in the plane x, with a doorway between y = `door` and `door` + 1.
TriangleSoup wallWithDoor(double x, double length, double door) {
  TriangleSoup wall;
  for (const auto& [from, to] : {std::array{0.0, door}, std::array{door + 1, length}}) {
    const auto first = static_cast<std::uint32_t>(wall.vertices.size());
    for (const Vec3& corner : {Vec3{x, from, 0}, Vec3{x, to, 0}, Vec3{x, to, 1}, Vec3{x, from, 1}})
      wall.vertices.push_back(corner);
    wall.triangles.push_back({first, first + 1, first + 2});
    wall.triangles.push_back({first, first + 2, first + 3});
  }
  return wall;
}

/// The floor of a crate with sides of one metre, and its four sides.
TriangleSoup crateAt(double x, double y) {
  TriangleSoup crate;
  for (const double z : {0.0, 1.0})
    for (const auto& [dx, dy] :
         {std::array{0.0, 0.0}, std::array{1.0, 0.0}, std::array{1.0, 1.0}, std::array{0.0, 1.0}})
      crate.vertices.push_back({x + dx, y + dy, z});
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    crate.triangles.push_back({k, next, next + 4});
    crate.triangles.push_back({k, next + 4, k + 4});
  }
  crate.triangles.push_back({4, 5, 6});
  crate.triangles.push_back({4, 6, 7});
  return crate;
}

int failed(const char* what) {
  std::fprintf(stderr, "failed: %s\n", what);
  return 1;
}

/// The crate closes the doorway on its way along the wall, and only then are there two parts to walk on.
int pushCrate() {
  constexpr double kSize = 20, kDoor = 8;
  EditableEnvironment level(floorOf(20));
  level.add(wallWithDoor(10, kSize, kDoor));
  const ObstacleId crate = level.add(crateAt(9.5, 2));
  const Pipeline pipeline = pipelineFor(*level.environment(), {.maxSlope = 45, .height = 2, .minimumArea = 2});
  ResultCache cache;  // only what the crate touches is computed again

  for (double y = 2; y <= 14; y += 2) {
    level.replace(crate, crateAt(9.5, y));
    std::atomic<int> steps{0};
    RunContext context([&steps](const RunEvent& event) {
      if (event.kind == RunEvent::Kind::StepFinished) ++steps;
    });
    const RunResult result = runPipeline(level.environment(), pipeline, context, &cache);
    // The crate's top is too small for the area filter.
    const std::size_t parts = findComponents(*result.mesh).list.size();
    std::printf("crate at y = %g: %.2f m2 in %zu parts, %.1f ms\n", y, result.summary.area, parts, result.totalMs);
    if (parts != (y == kDoor ? 2u : 1u)) return failed("the crate closes the doorway where it stands in it");
    if (steps.load() != static_cast<int>(pipeline.steps.size())) return failed("every step reports");

    RunContext silent;
    const RunResult anew = runPipeline(level.environment(), pipeline, silent);
    if (anew.mesh->vertices != result.mesh->vertices || anew.mesh->triangles != result.mesh->triangles)
      return failed("the result is that of a run from nothing");
  }
  return 0;
}

/// A large level on a thread of its own; this thread cancels as soon as the run reports.
int cancelRun() {
  const auto level = floorOf(400);
  std::atomic<bool> started{false}, wasCancelled{false};
  RunContext context([&started](const RunEvent&) { started = true; });
  std::thread worker([&] {
    try {
      runPipeline(level, defaultPipeline(*level), context);
    } catch (const Cancelled&) {
      wasCancelled = true;
    }
  });
  while (!started) std::this_thread::yield();
  const auto asked = std::chrono::steady_clock::now();
  context.cancel();
  worker.join();
  const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - asked;
  std::printf("cancelled after %.1f ms\n", waited.count());
  return wasCancelled ? 0 : failed("the run is cancelled");
}

}  // namespace

int main() { return pushCrate() + cancelRun(); }
