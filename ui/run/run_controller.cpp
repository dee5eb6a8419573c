// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_controller.hpp"

#include <algorithm>
#include <utility>

namespace footfall::ui {
namespace {

// Runs up to this time follow every edit, and every step of a drag, because nobody notices the wait.
constexpr double kLiveMs = 150;

}  // namespace

RunController::RunController(QObject* parent)
    : QObject(parent), ahead_(runs_, queue_, [this](const Pipeline& ahead) {
        return job_ || !environment() ? std::shared_ptr<RunJob>() : inputs_.makeJob(ahead);
      }) {
  connect(&follower_, &RunFollower::statusChanged, this, &RunController::statusChanged);
  connect(&follower_, &RunFollower::progressed, this, &RunController::progressed);
  connect(&schedule_, &RunSchedule::due, this, &RunController::work);
  connect(&schedule_, &RunSchedule::framePassed, this, &RunController::explainResult);
  connect(&margins_, &MarginKinds::found, this, &RunController::showMarginKinds);
  connect(&display_, &RunDisplay::contentReady, this, &RunController::contentReady);
  connect(&display_, &RunDisplay::cellsChanged, this, &RunController::cellsChanged);
  connect(&ahead_, &AheadRuns::changed, this, &RunController::aheadChanged);
}

RunController::~RunController() {
  if (job_) job_->context->cancel();
  ahead_.interrupt();
}

// --- Inputs, and when to run

void RunController::setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre) {
  stopJob(false);
  inputs_.setEnvironment(std::move(environment), centre);
  finished_.reset();
  finishedKey_.clear();
  statuses_.clear();
  forecast_.clear();
  forgetSteps();
  display_.clear();
  listProblems();
  emit statusChanged();
  start(Start::Asked);
}

// The rows have the list's errors before any run.
void RunController::listProblems() {
  statuses_.setFilters(inputs_.filters(), inputs_.skipped(), inputs_.findInvalidStep());
}

// Data of single steps belong to one environment.
void RunController::forgetSteps() {
  editPreviews_.clear();
  margins_.clear();
  display_.forgetBlocks();
  runs_.clear();
  forecast_.forgetSteps();
  runAhead({});
}

void RunController::editEnvironment(std::shared_ptr<const Environment> environment) {
  const bool overtakes = job_ != nullptr;
  const bool finishes = letsFinish();
  if (!finishes) stopJob(false);
  inputs_.editEnvironment(std::move(environment));
  finishedKey_.clear();
  statuses_.forgetFigures();
  forgetSteps();
  listProblems();
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
      std::ranges::equal(filters, inputs_.filters(), [](const auto& a, const auto& b) { return a.id == b.id; });
  inputs_.setFilters(filters);
  const std::string key = inputs_.key();
  const bool sameAsRunning = job_ && job_->key == key;
  followUp_ = !sameAsRunning && letsFinish();
  if (followUp_) {
    listProblems();
    // Shows the known changes of the present list before it runs.
    if (display_.hasResult()) display_.showChanges(makeEditJob()->changes);
    return;
  }
  const bool overtakes = job_ != nullptr;
  if (!sameAsRunning) stopJob(false);
  listProblems();
  const bool shown = finished_ && finished_->environment == environment() && finishedKey_ == key;
  const bool starting = environment() && !sameAsRunning && !shown;
  // Short runs update the statuses only at their end, because repainting the rows twice would slow them down.
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
  if (!environment() || sameAsRunning) return;
  display_.restore();
  schedule_.awaitFrame();  // the explanation that was stopped continues
  emit finished();         // the list has returned to the result
}

void RunController::setThreads(int threads) {
  if (inputs_.setThreads(threads) && environment()) editEnvironment(environment());
}

void RunController::setPlace(const RunPlace& place) {
  if (inputs_.setPlace(place) && environment()) editEnvironment(environment());
}

void RunController::setAutomatic(bool on) {
  if (on == automatic_) return;
  automatic_ = on;
  emit automaticChanged(on);
  if (on && environment() && !busy() && !upToDate()) start(Start::Edited);
}

void RunController::setDragging(bool dragging) {
  dragging_ = dragging;
  if (dragging) return;
  schedule_.endSettling();  // no edit follows
  if (!job_) schedule_.awaitFrame();
}

void RunController::runNow() {
  if (!environment()) return;
  stopJob(false);
  finishedKey_.clear();
  start(Start::Asked);
}

void RunController::cancel() {
  followUp_ = false;
  if (!job_) return margins_.clear();
  stopJob(true);
  display_.restore();
  schedule_.awaitFrame();
  emit statusChanged();
  emit cancelled();
}

void RunController::stopJob(bool cancelled) {
  if (!job_) return;
  job_->context->cancel();  // the run ends soon by itself; nothing waits for it
  schedule_.drop();
  follower_.leave();
  followUp_ = false;
  statuses_.stop(cancelled);
  job_.reset();
}

bool RunController::letsFinish() const {
  return dragging_ && automatic_ && job_ && !settling() && forecast_.expectedTime(*job_) <= kLiveMs;
}

// Explanations begin after the frame that shows the result. During a drag, another result follows at once.
void RunController::explainResult() {
  if (job_ || !environment()) return;
  editPreviews_.prepare(environment(), inputs_.centre());
  if (!dragging_) margins_.find();
}

void RunController::showMarginKinds(const RunOutcome& outcome, const std::string& key) {
  if (outcome.finished->environment == environment()) runs_.store(key, outcome.finished, outcome.content);
  if (outcome.finished == finished_) display_.setContent(outcome.content);
}

void RunController::nextAhead() {
  if (!job_ && environment()) ahead_.next();
}

// --- Results

bool RunController::upToDate() const {
  return finished_ && !busy() && finished_->environment == environment() && finishedKey_ == inputs_.key();
}

bool RunController::previews(int id) const {
  const auto placed = inputs_.find(id);
  return placed && editPreviews_.knows(placed->prefix, placed->step);
}

std::shared_ptr<const FinishedRun> RunController::finishedRunOf(const Pipeline& pipeline) const {
  return runs_.peek(keyOf(withoutSkipped(pipeline)));
}

// --- A run

// Makes a run of the list, compared with the last finished one.
std::shared_ptr<RunJob> RunController::makeEditJob() const {
  std::shared_ptr<RunJob> job = inputs_.makeListJob();
  job->follows = display_.hasResult();
  job->sameEnvironment = !finished_ || finished_->environment == environment();
  if (!finished_) return job;
  compareWithEarlier(*job, finished_->pipeline);
  if (!display_.hasResult()) job->changedBefore = nullptr;
  if (display_.hasResult() && job->sameEnvironment) job->changes = editPreviews_.changes(*job, finished_->pipeline);
  return job;
}

// The row of the step has the same message (listProblems()).
bool RunController::reportInvalidStep() {
  const std::optional<InvalidStep> step = inputs_.findInvalidStep();
  if (!step) return false;
  emit statusChanged();
  emit failed(step->place + QStringLiteral(": ") + step->message);
  return true;
}

void RunController::start(Start why) {
  if (!environment()) return;
  stopJob(false);
  if (reportInvalidStep()) return;

  const std::shared_ptr<RunJob> job = makeEditJob();
  if (why != Start::Asked && showKnown(job)) return;
  job_ = job;
  statuses_.begin(*job);
  follower_.follow(job);
  // The work begins now. The signal is sent later, because its receivers may edit or cancel, which must not happen
  // inside the present edit.
  QMetaObject::invokeMethod(
      this,
      [this, job] {
        if (job == job_) emit started();
      },
      Qt::QueuedConnection);
  editPreviews_.stop();
  margins_.stop();
  ahead_.interrupt();
  display_.begin(!job->changes.empty());
  const bool follows = why == Start::Overtaking || (why == Start::Edited && dragging_);
  schedule_.plan(follows && forecast_.expectedTime(*job) > kLiveMs ? RunSchedule::Begin::WhenEditsStop
                 : job->changes.empty()                            ? RunSchedule::Begin::AtOnce
                                                                   : RunSchedule::Begin::BehindFrame);
  if (!job->changes.empty()) display_.showChanges(job->changes);  // last, because receivers may cancel
}

void RunController::work() {
  job_->begun = RunEventBuffer::Clock::now();
  queue_.post([this, job = job_] {
    const auto outcome = std::make_shared<RunOutcome>(compute(*job));
    QMetaObject::invokeMethod(
        this, [this, job, outcome] { complete(job, *outcome); }, Qt::QueuedConnection);
  });
}

void RunController::complete(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome) {
  if (job != job_) return;  // cancelled or overtaken
  follower_.fetchLast();    // the last events may have arrived after the timer
  if (job != job_) return;  // their receivers have cancelled
  follower_.leave();
  job_.reset();
  if (!outcome.finished) return fail(outcome.error);
  if (job->environment == environment()) runs_.store(job->key, outcome.finished, outcome.content);
  showFinished(job, outcome, false);
  if (std::exchange(followUp_, false) && !job_ && !upToDate()) {
    start(Start::Edited);
  }
  nextAhead();
}

void RunController::fail(const QString& error) {
  statuses_.fail(error);
  display_.restore();
  schedule_.awaitFrame();
  emit statusChanged();
  followUp_ = false;
  if (error.isEmpty()) {
    emit cancelled();
  } else {
    emit failed(error);
  }
  nextAhead();
}

// `known` is true for a result of an earlier run.
void RunController::showFinished(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome, bool known) {
  finished_ = outcome.finished;
  finishedKey_ = job->key;
  const RunResult& result = finished_->result;
  statuses_.setResult(*job, result, known);
  if (job->environment != environment()) statuses_.forgetFigures();
  forecast_.remember(*job, result);
  display_.setResult(*job, outcome);
  margins_.setResult(job, outcome);
  emit statusChanged();
  if (job->environment == environment()) {  // a level that was replaced has no previews
    editPreviews_.follow(*job, result.mesh);
    schedule_.awaitFrame();
  }
  display_.show();
  emit finished();
}

// Shows a cached result at once.
bool RunController::showKnown(const std::shared_ptr<RunJob>& job) {
  const FinishedRuns::Entry* entry = runs_.find(job->key);
  if (!entry) return false;
  showFinished(job, {entry->run, entry->content, {}}, true);
  nextAhead();
  return true;
}

}  // namespace footfall::ui
