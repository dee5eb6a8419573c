// VerticalClearanceFilter: removes what has an obstacle within the clearance above it (design section 2, thesis 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <memory>

#include "core/filters/clearance_clipper.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/mesh_assembly.hpp"

namespace footfall {
namespace {

constexpr Index kFacesPerTask = 64;

std::shared_ptr<const PlanKernel> kernelWithHeight(const std::shared_ptr<const PlanKernel>& kernel, double height) {
  if (kernel->levelOf(height)) return kernel;
  std::vector<double> heights = kernel->heights();
  heights.push_back(height);
  return std::make_shared<PlanKernel>(kernel->sharedMesh(), std::move(heights));
}

}  // namespace

FilterOutcome applyVerticalClearance(const StatePtr& state, double height, RunContext& context) {
  FilterOutcome outcome;
  auto result = std::make_shared<WalkableState>(*state);
  result->kernel = kernelWithHeight(state->kernel, height);
  const PlanKernel& kernel = *result->kernel;
  const Index level = *kernel.levelOf(height);
  const auto count = static_cast<Index>(kernel.mesh().triangles.size());

  auto cuts = std::make_shared<std::vector<FaceCuts>>(count);
  tbb::enumerable_thread_specific<std::unique_ptr<ClearanceClipper>> clippers;
  std::atomic<Index> done{0};
  tbb::parallel_for(tbb::blocked_range<Index>(0, count, kFacesPerTask), [&](const auto& range) {
    auto& clipper = clippers.local();
    if (!clipper) clipper = std::make_unique<ClearanceClipper>(kernel, state->walkable, level);
    for (Index t = range.begin(); t != range.end(); ++t) {
      context.checkCancelled();
      if (state->walkable[t] != 0) (*cuts)[t] = clipper->clip(t, state->cuts ? &(*state->cuts)[t] : nullptr);
    }
    const Index finished = done.fetch_add(range.end() - range.begin(), std::memory_order_relaxed);
    context.progress(0.5 * finished / count);
  });
  for (const auto& clipper : clippers) outcome.fallbacks += clipper->fallbacks();
  result->cuts = std::move(cuts);
  result->mesh = assembleMesh(*result, context, outcome.fallbacks);
  outcome.state = std::move(result);
  return outcome;
}

}  // namespace footfall
