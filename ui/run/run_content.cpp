// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_content.hpp"

#include <algorithm>
#include <optional>

#include "core/base/parallel.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/view/geometry/coarse_geometry.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr double kSameArea = 1 - 1e-9;  // areas in summaries are rounded

const RemovalStyle* styleOf(const PipelineStep& step) {
  const RemovalStyle* const style = removalStyle(step.filter->type);
  if (!style || style->filter != FilterType::Radius) return style;
  if (step.values[1] == 0) return &removalStyle(PlaceVerdict::TooNearWall);
  if (step.values[0] == 0) return &removalStyle(PlaceVerdict::TooNearLedge);
  return style;
}

/// The result of a RadiusFilter that keeps away from walls only; empty where the steps up to it are no pipeline.
std::optional<RunResult> keepOffWalls(const RunJob& job, std::size_t step, RunContext& context) {
  Pipeline pipeline;
  for (std::size_t i = 0; i <= step; ++i) pipeline.steps.push_back(*job.steps[i]);
  pipeline.steps.back().values[1] = 0;
  try {
    return runPipeline(job.environment, pipeline, context, job.cache.get(), job.threads);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<RemovedShare> divide(const RunJob& job, const RunResult& result, const RemovedShare& share,
                                 RunContext& context) {
  const std::optional<RunResult> offWalls = keepOffWalls(job, share.step, context);
  if (!offWalls || !offWalls->mesh) return {share};
  const RemovedShare wall{&removalStyle(PlaceVerdict::TooNearWall), share.before, share.step};
  RemovedShare ledge{&removalStyle(PlaceVerdict::TooNearLedge), share.before, share.step};
  const double area = offWalls->summary.area;
  if (result.steps[share.step].out.area >= area * kSameArea) return {wall};
  if (area >= result.steps[share.step].in.area * kSameArea) return {ledge};
  ledge.before = offWalls->mesh;
  return {wall, ledge};
}

}  // namespace

std::vector<RemovedShare> removedShares(const RunJob& job, const RunResult& result) {
  std::vector<RemovedShare> shares;
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const RemovalStyle* style = styleOf(*job.steps[i]);
    // the step removed nothing
    if (!style || result.steps[i].out.area >= result.steps[i].in.area * kSameArea) continue;
    StepMeshes::Mesh before;
    if (!shares.empty()) {
      before = job.stepMeshes->find(job.prefixes[i]);
      if (!before) continue;
    }
    shares.push_back({style, before, i});
  }
  return shares;
}

bool isDivisible(const RunJob& job, const RemovedShare& share) {
  return share.style == removalStyle(FilterType::Radius) &&
         std::any_of(job.steps.begin(), job.steps.begin() + static_cast<std::ptrdiff_t>(share.step),
                     [](const PipelineStep* step) { return step->filter->type == FilterType::VerticalClearance; });
}

std::vector<RemovedShare> dividedShares(const RunJob& job, const RunResult& result,
                                        const std::vector<RemovedShare>& shares, RunContext& context) {
  std::vector<RemovedShare> divided;
  for (const RemovedShare& share : shares) {
    if (!isDivisible(job, share)) {
      divided.push_back(share);
      continue;
    }
    for (const RemovedShare& part : divide(job, result, share, context)) divided.push_back(part);
  }
  return divided;
}

ViewContent makeContent(const RunJob& job, const RunResult& result, const std::vector<RemovedShare>& shares,
                        const ViewContent& known) {
  ViewContent content;
  content.environmentLayers = known.environmentLayers;
  const bool large = job.environment->triangles.size() > kCoarseAbove;
  std::vector<FloorShare> floors;
  if (result.mesh && (large || !(known.environmentLayers || result.mesh->layers.empty())))
    floors = floorsUnder(*result.mesh, *job.environment);
  if (result.mesh && !known.environmentLayers)
    content.environmentLayers = makeEnvironmentLayers(*result.mesh, *job.environment, floors);
  const EnvironmentLayers* layers = content.environmentLayers.get();
  std::vector<const NavigationMesh*> before;
  for (const RemovedShare& share : shares) {
    if (!content.firstRemoval) {
      content.firstRemoval = share.style;
      continue;
    }
    before.push_back(share.before.get());
    content.removed.push_back({share.style, nullptr});
  }
  content.walkable = known.walkable;
  if (result.mesh) {
    content.walkable.resize(1);
    content.floorStates = makeFloorStates(*job.environment, *result.mesh, floors, before);
  }
  // The result comes first, because it takes longest.
  forRanges(before.size() + content.walkable.size(), 1, [&](std::size_t i, std::size_t) {
    if (i < content.walkable.size()) {
      if (!content.walkable[i]) content.walkable[i] = makeMeshGeometry(*result.mesh, job.centre, std::nullopt, layers);
      return;
    }
    const std::size_t k = i - content.walkable.size();
    content.removed[k].before = makeMeshGeometry(*before[k], job.centre, content.removed[k].style->paint, layers);
  });
  return content;
}

}  // namespace footfall::ui
