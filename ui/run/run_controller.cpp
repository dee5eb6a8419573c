// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_controller.hpp"

#include <algorithm>
#include <utility>

#include "core/pipeline/block_structure.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/run/run_job.hpp"
#include "ui/view/appearance.hpp"

namespace footfall::ui {

RunController::RunController(QObject* parent)
    : QObject(parent), previews_(std::make_shared<PreviewCache>()), cache_(std::make_shared<ResultCache>()) {
  drainTimer_.setSingleShot(true);
  connect(&drainTimer_, &QTimer::timeout, this, &RunController::drain);
  frameTimer_.setSingleShot(true);
  connect(&frameTimer_, &QTimer::timeout, this, &RunController::frameShown);
  settleTimer_.setSingleShot(true);
  connect(&settleTimer_, &QTimer::timeout, this, &RunController::endSettling);
}

RunController::~RunController() {
  if (job_) job_->context->cancel();
  if (aheadJob_) aheadJob_->context->cancel();
}

void RunController::setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre) {
  stopJob(StepState::Fresh);
  environment_ = std::move(environment);
  centre_ = centre;
  finished_.reset();
  finishedKey_.clear();
  shown_ = {};
  provisional_ = false;
  statuses_.clear();
  cache_ = std::make_shared<ResultCache>();  // a run that is still ending keeps the old ones
  forgetSteps();
  showLastCells();
  refreshStatuses();
  emit statusChanged();
  start(Start::Asked);
}

// What is known of single steps by their filters belongs to one environment.
void RunController::forgetSteps() {
  previews_ = std::make_shared<PreviewCache>();
  editPreviews_.clear();
  knownBlocks_.clear();
  runs_.clear();
  stepTimes_.clear();
  runAhead({});
}

void RunController::editEnvironment(std::shared_ptr<const Environment> environment) {
  const bool overtakes = job_ != nullptr;
  const bool finishes = letsFinish();
  if (!finishes) stopJob(StepState::Stale);
  environment_ = std::move(environment);
  finishedKey_.clear();
  for (auto& [id, status] : statuses_) status.prefix.clear();
  forgetSteps();
  refreshStatuses();
  followUp_ = finishes;
  if (finishes) return;
  if (automatic_) {
    start(overtakes ? Start::Overtaking : Start::Edited);
  } else {
    emit statusChanged();
  }
}

void RunController::setThreads(int threads) {
  if (std::exchange(threads_, threads) == threads || !environment_) return;
  cache_ = std::make_shared<ResultCache>();
  editEnvironment(environment_);
}

std::string RunController::runKey() const {
  std::string key;
  for (const FilterEntry& entry : filters_) {
    if (entry.step.enabled) key = extendPrefix(key, entry.step);
  }
  return key;
}

bool RunController::upToDate() const {
  return finished_ && !busy() && finished_->environment == environment_ && finishedKey_ == runKey();
}

void RunController::setFilters(const std::vector<FilterEntry>& filters) {
  const bool sameRows =
      std::ranges::equal(filters, filters_, [](const auto& a, const auto& b) { return a.id == b.id; });
  filters_ = filters;
  const std::string key = runKey();
  const bool sameAsRunning = job_ && job_->key == key;
  followUp_ = !sameAsRunning && letsFinish();
  if (followUp_) {
    refreshStatuses();
    showEdit();
    return;
  }
  const bool overtakes = job_ != nullptr;
  if (!sameAsRunning) stopJob(StepState::Stale);
  refreshStatuses();
  const bool shown = finished_ && finished_->environment == environment_ && finishedKey_ == key;
  const bool starting = environment_ && !sameAsRunning && !shown;
  // A run tells the statuses when it takes a while, and at its end: to repaint the rows twice costs it time.
  if (!starting || !sameRows) emit statusChanged();
  if (starting && automatic_) {
    start(overtakes ? Start::Overtaking : Start::Edited);
    return;
  }
  if (starting) {
    emit statusChanged();
    showLastResult();
    return;
  }
  if (!environment_ || sameAsRunning) return;
  showLastResult();
  showLastCells();
  emit finished();  // the list is back where the result is
}

void RunController::runNow() {
  if (!environment_) return;
  stopJob(StepState::Stale);
  finishedKey_.clear();
  start(Start::Asked);
}

void RunController::cancel() {
  followUp_ = false;
  if (!job_) return;
  stopJob(StepState::Cancelled);
  showLastResult();
  showLastCells();
  emit statusChanged();
  emit cancelled();
}

StepStatus RunController::status(int id) const {
  const auto found = statuses_.find(id);
  return found == statuses_.end() ? StepStatus{} : found->second;
}

bool RunController::previews(int id) const {
  std::string prefix;
  for (const FilterEntry& entry : filters_) {
    if (!entry.step.enabled) continue;
    if (entry.id == id) return editPreviews_.find(prefix + std::string(entry.step.filter->name)) != nullptr;
    prefix = extendPrefix(prefix, entry.step);
  }
  return false;
}

void RunController::stopJob(StepState unfinished) {
  if (!job_) return;
  job_->context->cancel();  // it ends by itself, soon; nobody waits
  settleTimer_.stop();
  followUp_ = false;
  for (const int id : job_->ids) {
    StepStatus& status = statuses_[id];
    if (status.state == StepState::Running || status.state == StepState::Fresh || status.state == StepState::Stale) {
      status.state = unfinished;
    }
  }
  job_.reset();
}

// An edit makes out of date only what comes after it.
void RunController::refreshStatuses() {
  std::map<int, StepStatus> kept;
  std::string prefix;
  for (const FilterEntry& entry : filters_) {
    StepStatus status = this->status(entry.id);
    if (!entry.step.enabled) {
      if (status.state != StepState::Off) status = {};
      status.state = StepState::Off;
    } else {
      prefix = extendPrefix(prefix, entry.step);
      const bool running = job_ && status.state == StepState::Running;
      if (status.prefix != prefix && !running) {
        const bool known = status.wallMs.has_value() || status.state == StepState::Stale;
        status.state = known ? StepState::Stale : StepState::Fresh;
        status.error.clear();
        status.note.clear();
      }
    }
    kept[entry.id] = status;
  }
  statuses_ = std::move(kept);
}

// What the runner would refuse before it begins belongs on the row where it stands.
bool RunController::reportInvalidStep() {
  Pipeline pipeline;
  for (const FilterEntry& entry : filters_) pipeline.steps.push_back(entry.step);
  const auto error = findStructureError(pipeline);
  if (!error) return false;
  const QString message = coreText(error->message);
  StepStatus& status = statuses_[filters_[error->step].id];
  status.state = StepState::Failed;
  status.error = message;
  emit statusChanged();
  emit failed(coreText(placeOfStep(pipeline, error->step)) + QStringLiteral(": ") + message);
  return true;
}

std::shared_ptr<RunController::Job> RunController::makeJob(const Pipeline& pipeline) const {
  auto job = std::make_shared<Job>();
  job->environment = environment_;
  job->centre = centre_;
  job->threads = threads_;
  job->previews = previews_;
  job->pipeline = pipeline;
  job->prefixes.emplace_back();
  for (const PipelineStep& step : job->pipeline.steps) {
    if (!step.enabled) continue;
    job->steps.push_back(&step);
    job->prefixes.push_back(extendPrefix(job->prefixes.back(), step));
  }
  job->key = job->prefixes.back();
  return job;
}

void RunController::start(Start why) {
  if (!environment_) return;
  stopJob(StepState::Stale);
  for (auto& [id, status] : statuses_) {
    if (status.state == StepState::Failed) status.state = StepState::Stale;
    status.error.clear();
  }
  if (reportInvalidStep()) return;

  Pipeline pipeline;
  for (const FilterEntry& entry : filters_) pipeline.steps.push_back(entry.step);
  const std::shared_ptr<Job> job = makeJob(pipeline);
  for (const FilterEntry& entry : filters_) {
    if (!entry.step.enabled) continue;
    job->ids.push_back(entry.id);
    StepStatus& status = statuses_[entry.id];
    if (status.state == StepState::Cancelled) status.state = StepState::Stale;
  }
  if (why != Start::Asked && takeKnown(job)) return;
  job->follows = shown_.mesh != nullptr;
  job->sameEnvironment = !finished_ || finished_->environment == environment_;
  findFirstChange(*job);
  preview(*job);
  const auto settle = settleTime(*job, why);
  listenTo(job);
  job_ = job;
  // The work begins now; who hears of it may edit or cancel, and not in the middle of the edit that led here.
  QMetaObject::invokeMethod(
      this,
      [this, job] {
        if (job == job_) emit started();
      },
      Qt::QueuedConnection);
  editPreviews_.stop();
  if (aheadJob_) aheadJob_->context->cancel();  // it comes again
  job->settling = settle.count() > 0;
  if (job->settling) settleTimer_.start(settle);
  if (job->changes.empty()) {
    if (!job->settling) work(job);
    return;
  }
  if (!job->settling) {
    job->waiting = true;
    frameTimer_.start(kFrameWait);
  }
  job->lastPicture = RunEventBuffer::Clock::now();
  provisional_ = true;
  ViewContent content = shown_.content;
  content.changes = job->changes;
  emit contentReady(content);  // last: who hears it may cancel
}

void RunController::listenTo(const std::shared_ptr<Job>& job) {
  job->events = std::make_unique<RunEventBuffer>(
      [this] { QMetaObject::invokeMethod(this, &RunController::scheduleDrain, Qt::QueuedConnection); });
  // The events are told to the job that they belong to; it outlives the context that it owns.
  Job* const raw = job.get();
  job->context = std::make_unique<RunContext>(
      [raw](const RunEvent& event) {
        if (event.kind == RunEvent::Kind::StepFinished && event.part && event.step + 1 < raw->prefixes.size()) {
          raw->previews->store(raw->prefixes[event.step + 1], event.part);
          const RemovalStyle* style = removalStyle(raw->steps[event.step]->filter->type);
          if (event.step == raw->firstChanged && raw->changes.empty() && raw->changedBefore && style)
            raw->changesOfStep = changedTriangles(*raw->changedBefore, *event.part, style->paint, raw->centre);
        }
        // Pictures are made here and not on the window's thread, which would wait for them.
        std::shared_ptr<const NavigationMeshGeometry> geometry;
        const bool piece = event.kind == RunEvent::Kind::PartReady || event.kind == RunEvent::Kind::CellFinished;
        if (event.part && piece) geometry = makeMeshGeometry(*event.part, raw->centre);
        if (event.part && !piece && !raw->follows) geometry = raw->stepPictures.make(*event.part, raw->centre);
        raw->events->add(event, std::move(geometry));
      },
      true);
}

void RunController::frameShown() {
  frameTimer_.stop();
  if (!job_) {
    editPreviews_.prepare(environment_, centre_);
  } else if (std::exchange(job_->waiting, false)) {
    work(job_);
  }
}

void RunController::work(const std::shared_ptr<Job>& job) {
  job->begun = RunEventBuffer::Clock::now();
  queue_.post([this, job, cache = cache_] {
    const auto outcome = std::make_shared<Outcome>(compute(*job, *cache));
    QMetaObject::invokeMethod(
        this, [this, job, outcome] { complete(job, *outcome); }, Qt::QueuedConnection);
  });
}

void RunController::findFirstChange(Job& job) const {
  if (!finished_) return;
  std::vector<const PipelineStep*> before;
  for (const PipelineStep& step : finished_->pipeline.steps) {
    if (step.enabled) before.push_back(&step);
  }
  std::size_t& i = job.firstChanged;
  while (i < before.size() && i < job.steps.size() && *before[i] == *job.steps[i]) ++i;
  if (shown_.mesh && i < before.size()) job.changedBefore = previews_->find(extendPrefix(job.prefixes[i], *before[i]));
}

RunController::Outcome RunController::compute(Job& job, ResultCache& cache) {
  Outcome outcome;
  try {
    job.context->checkCancelled();
    auto finished = std::make_shared<FinishedRun>();
    finished->environment = job.environment;
    finished->pipeline = job.pipeline;
    finished->result = runPipeline(job.environment, job.pipeline, *job.context, &cache, job.threads);
    outcome.content = makeContent(job, finished->result);
    outcome.finished = std::move(finished);
  } catch (const Cancelled&) {
    outcome = {};
  } catch (const std::bad_alloc&) {
    outcome.error = tr("memory ran out; close other programs or use a smaller environment");
  } catch (const std::exception& error) {
    outcome.error = coreText(error);
  }
  return outcome;
}

// Steps of a block run at the same time: the first of them stands for what went wrong.
void RunController::markUnfinished(const Job& job, const QString& error) {
  bool told = false;
  for (const int id : job.ids) {
    StepStatus& status = statuses_[id];
    if (status.state != StepState::Running) continue;
    status.state = error.isEmpty() || told ? StepState::Cancelled : StepState::Failed;
    if (!std::exchange(told, true)) status.error = error;
  }
}

void RunController::complete(const std::shared_ptr<Job>& job, const Outcome& outcome) {
  if (job != job_) return;  // cancelled or overtaken
  drained_ = RunEventBuffer::Clock::now();
  takeStatuses(job->events->fetch(), job->events->blocks());  // the last events may have come after the timer
  if (job != job_) return;                                    // somebody who heard of them has cancelled
  job_.reset();
  if (outcome.finished) {
    if (job->environment == environment_) runs_.store(job->key, outcome.finished, outcome.content);
    adopt(*job, outcome, false);
    if (std::exchange(followUp_, false) && !job_ && !upToDate()) {
      refreshStatuses();
      start(Start::Edited);
    }
    nextAhead();
    return;
  }
  markUnfinished(*job, outcome.error);
  showLastResult();
  showLastCells();
  emit statusChanged();
  followUp_ = false;
  if (outcome.error.isEmpty()) {
    emit cancelled();
  } else {
    emit failed(outcome.error);
  }
  nextAhead();
}

// Makes a finished run the one that is shown.
void RunController::adopt(const Job& job, const Outcome& outcome, bool known) {
  finished_ = outcome.finished;
  finishedKey_ = job.key;
  shown_ = {finished_->result.mesh, outcome.content};
  const std::vector<StepStatistics>& steps = finished_->result.steps;
  for (std::size_t i = 0; i < steps.size() && i < job.ids.size(); ++i) {
    StepStatus& status = statuses_[job.ids[i]];
    status.state = known || steps[i].fromCache ? StepState::Cached : StepState::Done;
    status.wallMs = steps[i].wallMs;
    status.trianglesIn = steps[i].in.triangles;
    status.trianglesOut = steps[i].out.triangles;
    status.note = coreText(steps[i].note);
    status.prefix = job.prefixes[i + 1];
  }
  stepTimes_.remember(steps, job.prefixes);
  provisional_ = false;
  knownBlocks_.follow(finished_->result, job.steps, job.prefixes);
  emit statusChanged();
  if (job.environment == environment_) keepPreviews(job);  // of a level that is there no more, there are none
  emit contentReady(outcome.content);
  showLastCells();
  emit finished();
}

// A result that is still there is shown at once.
bool RunController::takeKnown(const std::shared_ptr<Job>& job) {
  const FinishedRuns::Entry* entry = runs_.find(job->key);
  if (!entry) return false;
  Outcome outcome;
  outcome.finished = entry->run;
  outcome.content = entry->content;
  adopt(*job, outcome, true);
  nextAhead();
  return true;
}

}  // namespace footfall::ui
