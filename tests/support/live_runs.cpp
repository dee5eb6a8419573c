// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/live_runs.hpp"

#include <algorithm>
#include <cstdint>

#include "core/io/export.hpp"

namespace footfall::test {
using namespace detail;

TriangleSoup soupFor(const Soup& soup) {
  TriangleSoup result;
  for (const auto& t : soup.triangles()) {
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.insert(result.vertices.end(), t.begin(), t.end());
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

std::string exported(const RunResult& result) { return formatObj(*result.mesh, {}); }

RunResult run(const std::shared_ptr<const Environment>& environment, const std::string& pipeline, ResultCache* cache,
              int threads) {
  RunContext context;
  return runPipeline(environment, parsePipeline(pipeline, "test"), context, cache, threads);
}

bool agrees(const std::shared_ptr<const Environment>& environment, const std::string& pipeline, ResultCache& cache) {
  const RunResult live = run(environment, pipeline, &cache);
  const RunResult fresh = run(environment, pipeline, nullptr);
  return exported(live) == exported(fresh) && live.mesh->sourceTriangles == fresh.mesh->sourceTriangles &&
         live.mesh->obstacleEdges == fresh.mesh->obstacleEdges &&
         live.summary.obstacleEdges == fresh.summary.obstacleEdges &&
         std::equal(live.steps.begin(), live.steps.end(), fresh.steps.begin(), fresh.steps.end(),
                    [](const StepStatistics& a, const StepStatistics& b) { return a.out.area == b.out.area; });
}

std::string defaultFilters(double slope, double clearance) {
  return "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter " + std::to_string(slope) + "\nVerticalClearanceFilter " +
         std::to_string(clearance) + "\nAreaFilter 0.5\nSimplificationFilter\nLayerSubdivisionFilter\n";
}

}  // namespace footfall::test
