// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_controller.hpp"

#include <algorithm>

#include "core/pipeline/block_structure.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/filter_text.hpp"
#include "ui/run/run_progress.hpp"

namespace footfall::ui {
namespace {

// Runs that take no longer follow every edit, and every step of a drag: people see no wait.
constexpr double kLiveMs = 150;
// So long after the last edit a slow run begins, where edits follow each other; about the pause between two keys.
constexpr auto kSettle = std::chrono::milliseconds(300);
constexpr auto kFrameWait = std::chrono::milliseconds(60);     // a hidden view shows no frames
constexpr auto kDrainPeriod = std::chrono::milliseconds(100);  // between two updates of the window
constexpr auto kWatchPeriod = std::chrono::milliseconds(10);   // the same, before there is anything to see of a run
// What takes less is over before anybody has read how far it is, and each repaint of the window takes time from it.
constexpr auto kProgressAfter = std::chrono::milliseconds(150);

}  // namespace

RunController::RunController(QObject* parent)
    : QObject(parent),
      stepMeshes_(std::make_shared<StepMeshes>()),
      cache_(std::make_shared<ResultCache>()),
      ahead_(runs_, queue_, [this](const Pipeline& ahead) {
        return job_ || !environment_ ? std::shared_ptr<RunJob>() : makeJob(ahead);
      }) {
  drainTimer_.setSingleShot(true);
  connect(&drainTimer_, &QTimer::timeout, this, &RunController::drain);
  frameTimer_.setSingleShot(true);
  connect(&frameTimer_, &QTimer::timeout, this, &RunController::frameShown);
  settleTimer_.setSingleShot(true);
  connect(&settleTimer_, &QTimer::timeout, this, &RunController::endSettling);
  connect(&display_, &RunDisplay::contentReady, this, &RunController::contentReady);
  connect(&display_, &RunDisplay::cellsChanged, this, &RunController::cellsChanged);
  connect(&ahead_, &AheadRuns::changed, this, &RunController::aheadChanged);
}

RunController::~RunController() {
  if (job_) job_->context->cancel();
  ahead_.interrupt();
}

// --- What there is to run, and when

void RunController::setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre) {
  stopJob(StepState::Fresh);
  environment_ = std::move(environment);
  centre_ = centre;
  finished_.reset();
  finishedKey_.clear();
  statuses_.clear();
  forecast_.clear();
  cache_ = std::make_shared<ResultCache>();  // a run that is still ending keeps the old ones
  forgetSteps();
  display_.clear();
  statuses_.follow(filters_, busy());
  emit statusChanged();
  start(Start::Asked);
}

// What is known of single steps by their filters belongs to one environment.
void RunController::forgetSteps() {
  stepMeshes_ = std::make_shared<StepMeshes>();
  editPreviews_.clear();
  display_.forgetBlocks();
  runs_.clear();
  forecast_.forgetSteps();
  runAhead({});
}

void RunController::editEnvironment(std::shared_ptr<const Environment> environment) {
  const bool overtakes = job_ != nullptr;
  const bool finishes = letsFinish();
  if (!finishes) stopJob(StepState::Stale);
  environment_ = std::move(environment);
  finishedKey_.clear();
  statuses_.forgetFigures();
  forgetSteps();
  statuses_.follow(filters_, busy());
  followUp_ = finishes;
  if (finishes) return;
  if (automatic_) {
    start(overtakes ? Start::Overtaking : Start::Edited);
  } else {
    emit statusChanged();
  }
}

void RunController::setFilters(const std::vector<FilterEntry>& filters) {
  const bool sameRows =
      std::ranges::equal(filters, filters_, [](const auto& a, const auto& b) { return a.id == b.id; });
  filters_ = filters;
  const std::string key = keyOf(pipeline());
  const bool sameAsRunning = job_ && job_->key == key;
  followUp_ = !sameAsRunning && letsFinish();
  if (followUp_) {
    statuses_.follow(filters_, busy());
    // What the list as it is would change, before any run of it.
    if (display_.hasResult()) display_.showChanges(makeEditJob()->changes);
    return;
  }
  const bool overtakes = job_ != nullptr;
  if (!sameAsRunning) stopJob(StepState::Stale);
  statuses_.follow(filters_, busy());
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
    display_.restore();
    return;
  }
  if (!environment_ || sameAsRunning) return;
  display_.restore();
  emit finished();  // the list is back where the result is
}

void RunController::setThreads(int threads) {
  if (std::exchange(threads_, threads) == threads || !environment_) return;
  cache_ = std::make_shared<ResultCache>();
  editEnvironment(environment_);
}

void RunController::setAutomatic(bool on) {
  if (on == automatic_) return;
  automatic_ = on;
  emit automaticChanged(on);
  if (on && environment_ && !busy() && !upToDate()) start(Start::Edited);
}

void RunController::setDragging(bool dragging) {
  dragging_ = dragging;
  if (!dragging) endSettling();  // nothing follows
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
  display_.restore();
  emit statusChanged();
  emit cancelled();
}

void RunController::stopJob(StepState unfinished) {
  if (!job_) return;
  job_->context->cancel();  // it ends by itself, soon; nobody waits
  settleTimer_.stop();
  followUp_ = false;
  statuses_.stop(*job_, unfinished);
  job_.reset();
}

bool RunController::letsFinish() const {
  return dragging_ && automatic_ && job_ && !job_->settling && forecast_.expectedTime(*job_) <= kLiveMs;
}

void RunController::endSettling() {
  settleTimer_.stop();
  if (job_ && std::exchange(job_->settling, false)) work(job_);
}

void RunController::frameShown() {
  frameTimer_.stop();
  if (!job_) {
    editPreviews_.prepare(environment_, centre_);
  } else if (std::exchange(job_->waiting, false)) {
    work(job_);
  }
}

void RunController::nextAhead() {
  if (!job_ && environment_) ahead_.next();
}

// --- What is known

bool RunController::upToDate() const {
  return finished_ && !busy() && finished_->environment == environment_ && finishedKey_ == keyOf(pipeline());
}

bool RunController::previews(int id) const {
  std::string prefix;
  for (const FilterEntry& entry : filters_) {
    if (!entry.step.enabled) continue;
    if (entry.id == id) return editPreviews_.knows(prefix, entry.step);
    prefix = extendPrefix(prefix, entry.step);
  }
  return false;
}

std::optional<std::chrono::milliseconds> RunController::remaining() const {
  return job_ ? RunForecast::remaining(*job_, drained_) : std::nullopt;
}

std::shared_ptr<const FinishedRun> RunController::finishedRunOf(const Pipeline& pipeline) const {
  return runs_.peek(keyOf(pipeline));
}

// --- A run

Pipeline RunController::pipeline() const {
  Pipeline pipeline;
  for (const FilterEntry& entry : filters_) pipeline.steps.push_back(entry.step);
  return pipeline;
}

std::shared_ptr<RunJob> RunController::makeJob(const Pipeline& pipeline) const {
  std::shared_ptr<RunJob> job = makeRunJob(pipeline);
  job->environment = environment_;
  job->centre = centre_;
  job->threads = threads_;
  job->stepMeshes = stepMeshes_;
  job->cache = cache_;
  return job;
}

// A run of the list, beside the last finished one.
std::shared_ptr<RunJob> RunController::makeEditJob() const {
  std::shared_ptr<RunJob> job = makeJob(pipeline());
  for (const FilterEntry& entry : filters_) {
    if (entry.step.enabled) job->ids.push_back(entry.id);
  }
  job->follows = display_.hasResult();
  job->sameEnvironment = !finished_ || finished_->environment == environment_;
  if (!finished_) return job;
  compareWithEarlier(*job, finished_->pipeline);
  if (!display_.hasResult()) job->changedBefore = nullptr;
  if (display_.hasResult() && job->sameEnvironment) job->changes = editPreviews_.changes(*job, finished_->pipeline);
  return job;
}

// What the runner would refuse before it begins belongs on the row where it stands.
bool RunController::reportInvalidStep() {
  const Pipeline pipeline = this->pipeline();
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

void RunController::start(Start why) {
  if (!environment_) return;
  stopJob(StepState::Stale);
  statuses_.begin();
  if (reportInvalidStep()) return;

  const std::shared_ptr<RunJob> job = makeEditJob();
  for (const int id : job->ids) {
    StepStatus& status = statuses_[id];
    if (status.state == StepState::Cancelled) status.state = StepState::Stale;
  }
  if (why != Start::Asked && takeKnown(job)) return;
  listenTo(*job, [this] { QMetaObject::invokeMethod(this, &RunController::scheduleDrain, Qt::QueuedConnection); });
  job_ = job;
  // The work begins now; who hears of it may edit or cancel, and not in the middle of the edit that led here.
  QMetaObject::invokeMethod(
      this,
      [this, job] {
        if (job == job_) emit started();
      },
      Qt::QueuedConnection);
  editPreviews_.stop();
  ahead_.interrupt();
  display_.begin(!job->changes.empty());
  const bool follows = why == Start::Overtaking || (why == Start::Edited && dragging_);
  job->settling = follows && forecast_.expectedTime(*job) > kLiveMs;
  if (job->settling) settleTimer_.start(kSettle);
  if (job->changes.empty()) {
    if (!job->settling) work(job);
    return;
  }
  if (!job->settling) {
    job->waiting = true;
    frameTimer_.start(kFrameWait);
  }
  display_.showChanges(job->changes);  // last: who hears it may cancel
}

void RunController::work(const std::shared_ptr<RunJob>& job) {
  job->begun = RunEventBuffer::Clock::now();
  queue_.post([this, job] {
    const auto outcome = std::make_shared<RunOutcome>(compute(*job));
    QMetaObject::invokeMethod(
        this, [this, job, outcome] { complete(job, *outcome); }, Qt::QueuedConnection);
  });
}

void RunController::complete(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome) {
  if (job != job_) return;  // cancelled or overtaken
  drained_ = RunEventBuffer::Clock::now();
  takeStatuses(job->events->fetch(), job->events->blocks());  // the last events may have come after the timer
  if (job != job_) return;                                    // somebody who heard of them has cancelled
  job_.reset();
  if (outcome.finished) {
    if (job->environment == environment_) runs_.store(job->key, outcome.finished, outcome.content);
    adopt(*job, outcome, false);
    if (std::exchange(followUp_, false) && !job_ && !upToDate()) {
      statuses_.follow(filters_, busy());
      start(Start::Edited);
    }
    nextAhead();
    return;
  }
  statuses_.fail(*job, outcome.error);
  display_.restore();
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
void RunController::adopt(const RunJob& job, const RunOutcome& outcome, bool known) {
  finished_ = outcome.finished;
  finishedKey_ = job.key;
  const RunResult& result = finished_->result;
  statuses_.adopt(job, result, known);
  forecast_.remember(job, result);
  display_.setResult(job, outcome);
  emit statusChanged();
  if (job.environment == environment_) {  // of a level that is there no more, there are no previews
    editPreviews_.follow(job, result.mesh);
    frameTimer_.start(kFrameWait);
  }
  display_.show();
  emit finished();
}

// A result that is still there is shown at once.
bool RunController::takeKnown(const std::shared_ptr<RunJob>& job) {
  const FinishedRuns::Entry* entry = runs_.find(job->key);
  if (!entry) return false;
  adopt(*job, {entry->run, entry->content, {}}, true);
  nextAhead();
  return true;
}

// --- What a run tells while it goes on

void RunController::scheduleDrain() {
  if (!job_ || drainTimer_.isActive()) return;
  const auto period = display_.waitsForPicture() ? kWatchPeriod : kDrainPeriod;
  const auto due = std::chrono::ceil<std::chrono::milliseconds>(drained_ + period - RunEventBuffer::Clock::now());
  drainTimer_.start(std::max(due, std::chrono::milliseconds(0)));
}

void RunController::drain() {
  if (!job_) return;
  drained_ = RunEventBuffer::Clock::now();
  const std::vector<RunEventBuffer::Step> steps = job_->events->fetch();
  const std::vector<RunEventBuffer::Block> blocks = job_->events->blocks();
  // Somebody who hears of them may cancel.
  takeStatuses(steps, blocks);
  if (job_) display_.showCells(blocks);
  if (job_) display_.showParts(*job_, steps);
}

void RunController::takeStatuses(const std::vector<RunEventBuffer::Step>& steps,
                                 const std::vector<RunEventBuffer::Block>& blocks) {
  double done = 0;
  QString text = tr("Finishing");
  for (std::size_t i = 0; i < steps.size() && i < job_->ids.size(); ++i) {
    const RunEventBuffer::Step& step = steps[i];
    if (step.finished) {
      forecast_.take(*job_, i, step, false, 1, drained_);
      statuses_.finish(*job_, i, step);
      done += 1;
      continue;
    }
    const BlockPlace place = placeInBlock(i, steps, blocks);
    if (place.waits) continue;  // as it was
    StepStatus& status = statuses_[job_->ids[i]];
    status.state = StepState::Running;
    status.fraction = place.block ? place.fraction : step.fraction;
    forecast_.take(*job_, i, step, place.block, status.fraction, drained_);
    text = place.block ? place.text : filterText(job_->steps[i]->filter->label);
    done += status.fraction;
  }
  if (drained_ - job_->begun > kProgressAfter) {
    emit progressed(done / static_cast<double>(job_->ids.size() + 1), text);
    emit statusChanged();
  }
}

}  // namespace footfall::ui
