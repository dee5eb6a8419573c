// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_job.hpp"

#include <QCoreApplication>
#include <optional>
#include <utility>

#include "core/base/parallel_ranges.hpp"
#include "footfall/errors.hpp"
#include "ui/base/core_text.hpp"
#include "ui/run/provisional_content.hpp"
#include "ui/view/appearance.hpp"
#include "ui/view/coarse_geometry.hpp"

namespace footfall::ui {
namespace {

constexpr double kSameArea = 1 - 1e-9;  // areas in summaries are rounded

void keepMesh(RunJob& job, const RunEvent& event) {
  if (job.isDividing) return;
  if (event.kind == RunEvent::Kind::StepFinished && event.part && event.step + 1 < job.prefixes.size())
    job.stepMeshes->store(job.prefixes[event.step + 1], event.part);
}

/// What was walkable before some of it was removed for one reason.
struct RemovedShare {
  const RemovalStyle* style = nullptr;
  StepMeshes::Mesh before;
};

/// What a RadiusFilter would leave that kept away from walls only; nothing where it does not know them.
std::optional<RunResult> keepOffWalls(RunJob& job, std::size_t step) {
  Pipeline pipeline;
  for (std::size_t i = 0; i <= step; ++i) pipeline.steps.push_back(*job.steps[i]);
  pipeline.steps.back().values[1] = 0;
  job.isDividing = true;
  std::optional<RunResult> result;
  try {
    result = runPipeline(job.environment, pipeline, *job.context, job.cache.get(), job.threads);
  } catch (const InputError&) {  // no clearance before it
  }
  job.isDividing = false;
  return result;
}

// Places that are too near a wall and a ledge count as too near a wall, as in answers to why.
std::vector<RemovedShare> sharesOfRadius(RunJob& job, const RunResult& result, std::size_t step,
                                         const StepMeshes::Mesh& before) {
  const RemovalStyle* const wall = &removalStyle(Removal::NearWall);
  const RemovalStyle* const ledge = &removalStyle(Removal::NearLedge);
  const std::vector<double>& values = job.steps[step]->values;
  if (values[1] == 0) return {{wall, before}};
  if (values[0] == 0) return {{ledge, before}};
  const std::optional<RunResult> offWalls = keepOffWalls(job, step);
  if (!offWalls || !offWalls->mesh) return {{&removalStyle(Removal::NearBorder), before}};
  const double area = offWalls->summary.area;
  if (result.steps[step].out.area >= area * kSameArea) return {{wall, before}};
  if (area >= result.steps[step].in.area * kSameArea) return {{ledge, before}};
  return {{wall, before}, {ledge, offWalls->mesh}};
}

// The environment's own floors stand for what was walkable before the first, which is null.
std::vector<RemovedShare> removedShares(RunJob& job, const RunResult& result) {
  std::vector<RemovedShare> shares;
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const RemovalStyle* style = removalStyle(job.steps[i]->filter->type);
    if (!style || result.steps[i].out.area >= result.steps[i].in.area * kSameArea) continue;  // it removed nothing
    StepMeshes::Mesh before;
    if (!shares.empty()) {
      before = job.stepMeshes->find(job.prefixes[i]);
      if (!before) continue;
    }
    if (style->filter == FilterType::Radius) {
      for (const RemovedShare& share : sharesOfRadius(job, result, i, before)) shares.push_back(share);
    } else {
      shares.push_back({style, before});
    }
  }
  return shares;
}

ViewContent makeContent(RunJob& job, const RunResult& result) {
  ViewContent content;
  if (result.mesh) content.environmentLayers = makeEnvironmentLayers(*result.mesh, *job.environment);
  const EnvironmentLayers* layers = content.environmentLayers.get();
  std::vector<StepMeshes::Mesh> before;
  for (const RemovedShare& share : removedShares(job, result)) {
    if (!content.firstRemoval) {
      content.firstRemoval = share.style;
      continue;
    }
    before.push_back(share.before);
    content.removed.push_back({share.style, nullptr});
  }
  if (result.mesh) {
    content.walkable.emplace_back();
    std::vector<const NavigationMesh*> meshes;
    for (const StepMeshes::Mesh& mesh : before) meshes.push_back(mesh.get());
    content.floorStates = makeFloorStates(*job.environment, *result.mesh, meshes);
  }
  // The result, which takes longest, first.
  forRanges(before.size() + content.walkable.size(), 1, [&](std::size_t i, std::size_t) {
    if (i < content.walkable.size()) {
      content.walkable[i] = makeMeshGeometry(*result.mesh, job.centre, std::nullopt, layers);
      return;
    }
    const std::size_t k = i - content.walkable.size();
    content.removed[k].before = makeMeshGeometry(*before[k], job.centre, content.removed[k].style->paint, layers);
  });
  return content;
}

}  // namespace

std::vector<const PipelineStep*> enabledSteps(const Pipeline& pipeline) {
  std::vector<const PipelineStep*> steps;
  for (const PipelineStep& step : pipeline.steps) {
    if (step.enabled) steps.push_back(&step);
  }
  return steps;
}

std::string keyOf(const Pipeline& pipeline) {
  std::string key;
  for (const PipelineStep* step : enabledSteps(pipeline)) key = extendPrefix(key, *step);
  return key;
}

std::shared_ptr<const NavigationMeshGeometry> StepPictures::make(const NavigationMesh& mesh, const Vec3& centre) {
  using Clock = RunEventBuffer::Clock;
  constexpr int kShare = 10;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  const Clock::time_point begun = Clock::now();
  if (!lock || begun < next_) return nullptr;
  std::shared_ptr<const NavigationMeshGeometry> made = makeMeshGeometry(mesh, centre);
  next_ = Clock::now() + kShare * (Clock::now() - begun);
  return made;
}

std::shared_ptr<RunJob> makeRunJob(const Pipeline& pipeline) {
  auto job = std::make_shared<RunJob>();
  job->pipeline = pipeline;
  job->steps = enabledSteps(job->pipeline);
  job->prefixes.emplace_back();
  for (const PipelineStep* step : job->steps) job->prefixes.push_back(extendPrefix(job->prefixes.back(), *step));
  job->key = job->prefixes.back();
  return job;
}

void listenTo(RunJob& job, std::function<void()> notify) {
  job.events = std::make_unique<RunEventBuffer>(std::move(notify));
  // The job outlives the context that it owns.
  job.context = std::make_unique<RunContext>(
      [&job](const RunEvent& event) {
        if (job.isDividing) return;
        keepMesh(job, event);
        if (event.kind == RunEvent::Kind::StepFinished && event.part && event.step + 1 < job.prefixes.size()) {
          const RemovalStyle* style = removalStyle(job.steps[event.step]->filter->type);
          if (event.step == job.firstChanged && job.changes.empty() && job.changedBefore && style)
            job.changesOfStep = changedTriangles(*job.changedBefore, *event.part, style->paint, job.centre);
        }
        // Pictures are made here and not on the window's thread, which would wait for them.
        std::shared_ptr<const NavigationMeshGeometry> geometry;
        const bool piece = event.kind == RunEvent::Kind::PartReady || event.kind == RunEvent::Kind::CellFinished;
        if (event.part && piece) geometry = makeMeshGeometry(*event.part, job.centre);
        if (event.part && !piece && !job.follows) geometry = job.stepPictures.make(*event.part, job.centre);
        job.events->add(event, std::move(geometry));
      },
      true);
}

void keepStepMeshes(RunJob& job) {
  job.context = std::make_unique<RunContext>([&job](const RunEvent& event) { keepMesh(job, event); }, true);
}

void compareWithEarlier(RunJob& job, const Pipeline& earlier) {
  const std::vector<const PipelineStep*> before = enabledSteps(earlier);
  std::size_t& i = job.firstChanged;
  while (i < before.size() && i < job.steps.size() && *before[i] == *job.steps[i]) ++i;
  if (i < before.size()) job.changedBefore = job.stepMeshes->find(extendPrefix(job.prefixes[i], *before[i]));
}

RunOutcome compute(RunJob& job) {
  RunOutcome outcome;
  try {
    job.context->checkCancelled();
    auto finished = std::make_shared<FinishedRun>();
    finished->environment = job.environment;
    finished->pipeline = job.pipeline;
    finished->result = runPipeline(job.environment, job.pipeline, *job.context, job.cache.get(), job.threads);
    outcome.content = makeContent(job, finished->result);
    outcome.finished = std::move(finished);
  } catch (const Cancelled&) {
    outcome = {};
  } catch (const std::bad_alloc&) {
    outcome.error = QCoreApplication::translate("footfall::ui::RunController",
                                                "memory ran out; close other programs or use a smaller environment");
  } catch (const std::exception& error) {
    outcome.error = coreText(error);
  }
  return outcome;
}

}  // namespace footfall::ui
