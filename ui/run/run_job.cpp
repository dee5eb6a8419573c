// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_job.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QUuid>
#include <algorithm>
#include <utility>

#include "core/distributed/folder_exchange.hpp"
#include "core/pipeline/block_structure.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/run/provisional_content.hpp"
#include "ui/run/run_content.hpp"
#include "ui/run/run_places.hpp"
#include "ui/run/run_threads.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

// The time after which files of other machines must be visible: a network folder shows them up to a minute late (NFS:
// acregmax, acdirmax).
constexpr double kFarPatienceMs = 90000;
// mpirun may wait for ever for a process that died while it was started.
constexpr double kStartMs = 60000;

void keepMesh(RunJob& job, const RunEvent& event) {
  if (event.kind == RunEvent::Kind::StepFinished && event.part && event.step + 1 < job.prefixes.size())
    job.stepMeshes->store(job.prefixes[event.step + 1], event.part);
}

// A folder for one run; for runs on other machines, one that all of them share.
std::string jobFolder(const RunPlace& place) {
  const bool isHere = place.kind == RunPlace::Kind::Processes || place.folder.empty();
  const QString in = isHere ? QDir::tempPath() : QString::fromStdString(place.folder);
  return (in + QStringLiteral("/footfall-") + QUuid::createUuid().toString(QUuid::Id128).left(12)).toStdString();
}

// Runs the cells in other processes, and the other steps in this one. Where the cache has all blocks, no process is
// started; otherwise the processes begin with the first block, even if the cache has it.
void runElsewhere(RunJob& job, FinishedRun& finished) {
  FolderExchange::Options options;
  options.folder = jobFolder(job.place);
  options.threads = job.threads > 0 ? job.threads : processorCount();
  const bool isHere = job.place.kind == RunPlace::Kind::Processes;
  if (!isHere) options.patienceMs = kFarPatienceMs;
  if (job.place.kind != RunPlace::Kind::Slurm) options.startMs = kStartMs;  // the wait in Slurm's queue is not limited
  const int threadsOfEach = isHere ? std::max(1, options.threads / job.place.processes) : 0;
  options.work = [&job, threadsOfEach](const std::string& folder, Poll poll) {
    writeJob(folder, *job.environment, formatPipeline(job.pipeline));
    return runJob(folder, job.place, runPrograms(), threadsOfEach, poll);
  };
  options.ranksKnown = [&job, &finished, own = options.threads](const std::vector<int>& threads) {
    finished.ranks = {own, threads};
    if (job.events) job.events->setRanks(finished.ranks);
  };
  FolderExchange exchange(std::move(options));
  finished.result = runTogether(job.environment, job.pipeline, *job.context, exchange, job.threads, job.cache.get());
}

}  // namespace

Pipeline withoutSkipped(Pipeline pipeline) {
  bool hasClearance = false;
  for (PipelineStep& step : pipeline.steps) {
    if (step.enabled && step.filter->type == FilterType::VerticalClearance) hasClearance = true;
    if (!hasClearance && needsClearance(step)) step.enabled = false;
  }
  return pipeline;
}

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
        keepMesh(job, event);
        const bool isPiece = event.kind == RunEvent::Kind::Progress || event.kind == RunEvent::Kind::PartReady ||
                             event.kind == RunEvent::Kind::CellFinished;
        if (!isPiece && job.processors) job.processors->sample();
        if (event.kind == RunEvent::Kind::StepFinished && event.part && event.step + 1 < job.prefixes.size()) {
          const RemovalStyle* style = removalStyle(job.steps[event.step]->filter->type);
          if (event.step == job.firstChanged && job.changes.empty() && job.changedBefore && style)
            job.changesOfStep = changedTriangles(*job.changedBefore, *event.part, style->paint, job.centre);
        }
        // Geometry is made on this thread, so that the window's thread need not wait for it.
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
    job.processors = std::make_unique<ProcessorWatch>();
    auto finished = std::make_shared<FinishedRun>();
    finished->environment = job.environment;
    finished->pipeline = job.pipeline;
    if (job.place.kind == RunPlace::Kind::ThisProcess)
      finished->result = runPipeline(job.environment, job.pipeline, *job.context, job.cache.get(), job.threads);
    else
      runElsewhere(job, *finished);
    job.processors->sample();
    finished->processors = job.processors->use();
    const std::vector<RemovedShare> shares = removedShares(job, finished->result);
    outcome.content = makeContent(job, finished->result, shares);
    outcome.content.hasMixedMargins = std::ranges::any_of(shares, [&](const auto& s) { return isDivisible(job, s); });
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
