// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run_controller.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "core/pipeline/block_structure.hpp"
#include "ui/appearance.hpp"

namespace footfall {
namespace {

constexpr auto kDrainPeriod = std::chrono::milliseconds(100);  // between two updates of the window
constexpr auto kWatchPeriod = std::chrono::milliseconds(10);   // the same, before there is anything to see of a run
// What a run shows first, it shows at once; then not more often than this: drawing takes time from computing.
constexpr auto kPicturePeriod = std::chrono::milliseconds(150);
// The same where the change itself is on the screen already: pieces tell little more, and their frames are long ones.
constexpr auto kDetailPeriod = std::chrono::milliseconds(1000);
// What takes less is over before anybody has read how far it is, and each repaint of the window takes time from it.
constexpr auto kProgressAfter = std::chrono::milliseconds(150);
// A hidden view shows no frames.
constexpr auto kFrameWait = std::chrono::milliseconds(60);
constexpr double kSameArea = 1 - 1e-9;  // areas in summaries are rounded
constexpr std::size_t kPreviews = 32;   // as many as ResultCache keeps states

std::string extendPrefix(const std::string& prefix, const PipelineStep& step) {
  return prefix + formatStep(step) + '\n';
}

double milliseconds(RunEventBuffer::Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

/// Thread-safe; the least recently used goes first.
class RunController::PreviewCache {
 public:
  void store(const std::string& prefix, MeshPtr mesh) {
    const std::scoped_lock lock(mutex_);
    entries_.remove_if([&](const auto& entry) { return entry.first == prefix; });
    entries_.emplace_front(prefix, std::move(mesh));
    if (entries_.size() > kPreviews) entries_.pop_back();
  }
  MeshPtr find(const std::string& prefix) {
    const std::scoped_lock lock(mutex_);
    for (auto it = entries_.begin(); it != entries_.end(); ++it) {
      if (it->first != prefix) continue;
      entries_.splice(entries_.begin(), entries_, it);
      return it->second;
    }
    return nullptr;
  }

 private:
  std::mutex mutex_;
  std::list<std::pair<std::string, MeshPtr>> entries_;
};

/// One run: shared by the window and the threads that work on it.
struct RunController::Job {
  std::shared_ptr<const Environment> environment;
  Vec3 centre;
  Pipeline pipeline;
  std::string key;
  std::vector<int> ids;                    // of the enabled steps
  std::vector<const PipelineStep*> steps;  // the enabled ones, inside `pipeline`
  std::vector<std::string> prefixes;       // prefixes[i]: steps before the enabled step i, and one more for all
  RunEventBuffer::Clock::time_point begun = RunEventBuffer::Clock::now();
  bool follows = false;  // there is an earlier result, which is shown until more is known
  // What the window shows of it while it runs; the window's own.
  std::size_t shownStep = static_cast<std::size_t>(-1), shownParts = 0;
  std::optional<RunEventBuffer::Clock::time_point> lastPicture;
  // Over the last result: known from the edit itself, or else from the first step that differs once it has run.
  EditPreview::Surfaces changes;
  bool waiting = false;  // for the frame that shows what is known from the edit
  // The first step that is not the same as in the last finished run, and what it gave there.
  std::size_t firstChanged = 0;
  MeshPtr changedBefore;
  EditPreview::Surfaces changesOfStep;  // written by the thread that computes, before the event of that step
  std::shared_ptr<PreviewCache> previews;
  std::unique_ptr<RunEventBuffer> events;
  std::unique_ptr<RunContext> context;
};

struct RunController::Outcome {
  std::shared_ptr<const FinishedRun> finished;
  ViewContent content;
  QString error;  // empty: finished or cancelled
};

RunController::RunController(QObject* parent)
    : QObject(parent),
      previews_(std::make_shared<PreviewCache>()),
      cache_(std::make_shared<ResultCache>()),
      preparing_(std::make_shared<RunContext>()) {
  drainTimer_.setSingleShot(true);
  connect(&drainTimer_, &QTimer::timeout, this, &RunController::drain);
  frameTimer_.setSingleShot(true);
  connect(&frameTimer_, &QTimer::timeout, this, &RunController::frameShown);
}

RunController::~RunController() {
  if (job_) job_->context->cancel();
  preparing_->cancel();
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
  previews_ = std::make_shared<PreviewCache>();
  preparing_->cancel();
  preparing_ = std::make_shared<RunContext>();
  editPreviews_.clear();
  missing_.clear();
  refreshStatuses();
  emit statusChanged();
  start();
}

std::string RunController::runKey() const {
  std::string key;
  for (const FilterEntry& entry : filters_) {
    if (entry.step.enabled) key = extendPrefix(key, entry.step);
  }
  return key;
}

bool RunController::upToDate() const { return finished_ && !busy() && finishedKey_ == runKey(); }

void RunController::setFilters(const std::vector<FilterEntry>& filters) {
  const bool sameRows =
      std::ranges::equal(filters, filters_, [](const auto& a, const auto& b) { return a.id == b.id; });
  filters_ = filters;
  const std::string key = runKey();
  const bool sameAsRunning = job_ && job_->key == key;
  if (!sameAsRunning) stopJob(StepState::Stale);
  refreshStatuses();
  const bool starting = environment_ && !sameAsRunning && !(finished_ && finishedKey_ == key);
  // A run tells the statuses when it takes a while, and at its end: to repaint the rows twice costs it time.
  if (!starting || !sameRows) emit statusChanged();
  if (starting) {
    start();
    return;
  }
  if (!environment_ || sameAsRunning) return;
  showLastResult();
  emit finished();  // the list is back where the result is
}

void RunController::runNow() {
  if (!environment_) return;
  stopJob(StepState::Stale);
  finishedKey_.clear();
  start();
}

void RunController::cancel() {
  if (!job_) return;
  stopJob(StepState::Cancelled);
  showLastResult();
  emit statusChanged();
  emit cancelled();
}

// In place of what a run that did not finish has shown.
void RunController::showLastResult() {
  if (std::exchange(provisional_, false)) emit contentReady(shown_.content);
}

StepStatus RunController::status(int id) const {
  const auto found = statuses_.find(id);
  return found == statuses_.end() ? StepStatus{} : found->second;
}

bool RunController::previews(int id) const {
  std::string prefix;
  for (const FilterEntry& entry : filters_) {
    if (!entry.step.enabled) continue;
    if (entry.id == id) return editPreviews_.contains(prefix + std::string(entry.step.filter->name));
    prefix = extendPrefix(prefix, entry.step);
  }
  return false;
}

void RunController::stopJob(StepState unfinished) {
  if (!job_) return;
  job_->context->cancel();  // it ends by itself, soon; nobody waits
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
  const auto report = [&](std::size_t step, const QString& message) {
    StepStatus& status = statuses_[filters_[step].id];
    status.state = StepState::Failed;
    status.error = message;
    emit statusChanged();
    emit failed(QString::fromStdString(placeOfStep(pipeline, step)) + QStringLiteral(": ") + message);
    return true;
  };
  if (const auto error = findStructureError(pipeline))
    return report(error->step, QString::fromStdString(error->message));
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (step.enabled && !step.filter->runs) {
      return report(i, tr("does not run yet; switch the strategy and its Collapse off, the result is the same"));
    }
  }
  return false;
}

void RunController::start() {
  if (!environment_) return;
  stopJob(StepState::Stale);
  for (auto& [id, status] : statuses_) {
    if (status.state == StepState::Failed) status.state = StepState::Stale;
    status.error.clear();
  }
  if (reportInvalidStep()) return;

  auto job = std::make_shared<Job>();
  job->environment = environment_;
  job->centre = centre_;
  job->previews = previews_;
  job->follows = shown_.mesh != nullptr;
  for (const FilterEntry& entry : filters_) job->pipeline.steps.push_back(entry.step);
  job->prefixes.emplace_back();
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    const PipelineStep& step = job->pipeline.steps[i];
    if (!step.enabled) continue;
    job->ids.push_back(filters_[i].id);
    job->steps.push_back(&step);
    job->prefixes.push_back(extendPrefix(job->prefixes.back(), step));
    StepStatus& status = statuses_[filters_[i].id];
    if (status.state == StepState::Cancelled) status.state = StepState::Stale;
  }
  job->key = job->prefixes.back();
  findFirstChange(*job);
  preview(*job);
  job->events = std::make_unique<RunEventBuffer>(
      [this] { QMetaObject::invokeMethod(this, &RunController::scheduleDrain, Qt::QueuedConnection); });
  // The events are told to the job that they belong to; it outlives the context that it owns.
  Job* const raw = job.get();
  job->context = std::make_unique<RunContext>(
      [raw](const RunEvent& event) {
        if (event.kind == RunEvent::Kind::StepFinished && event.part && event.step + 1 < raw->prefixes.size()) {
          raw->previews->store(raw->prefixes[event.step + 1], event.part);
          const RemovalStyle* style = removalStyle(raw->steps[event.step]->filter->name);
          if (event.step == raw->firstChanged && raw->changes.empty() && raw->changedBefore && style)
            raw->changesOfStep = changedTriangles(*raw->changedBefore, *event.part, style->paint, raw->centre);
        }
        // Pictures are made here and not on the window's thread, which would wait for them.
        std::shared_ptr<const MeshGeometry> geometry;
        if (event.part && (event.kind == RunEvent::Kind::PartReady || !raw->follows))
          geometry = makeMeshGeometry(*event.part, raw->centre);
        raw->events->add(event, std::move(geometry));
      },
      true);
  job_ = job;
  // The work begins now; who hears of it may edit or cancel, and not in the middle of the edit that led here.
  QMetaObject::invokeMethod(
      this,
      [this, job] {
        if (job == job_) emit started();
      },
      Qt::QueuedConnection);
  preparing_->cancel();
  preparing_ = std::make_shared<RunContext>();
  if (job->changes.empty()) {
    work(job);
    return;
  }
  job->waiting = true;
  frameTimer_.start(kFrameWait);
  job->lastPicture = RunEventBuffer::Clock::now();
  provisional_ = true;
  ViewContent content = shown_.content;
  content.changes = job->changes;
  emit contentReady(content);  // last: who hears it may cancel
}

void RunController::frameShown() {
  frameTimer_.stop();
  if (!job_) {
    preparePreviews();
  } else if (std::exchange(job_->waiting, false)) {
    work(job_);
  }
}

void RunController::work(const std::shared_ptr<Job>& job) {
  queue_.post([this, job, cache = cache_] {
    const auto outcome = std::make_shared<Outcome>(compute(*job, *cache));
    QMetaObject::invokeMethod(
        this, [this, job, outcome] { complete(job, *outcome); }, Qt::QueuedConnection);
  });
}

// An edit of one parameter, which stands for most of what somebody does here while looking at the view.
void RunController::preview(Job& job) const {
  if (!finished_ || !shown_.mesh) return;
  std::vector<const PipelineStep*> before;
  for (const PipelineStep& step : finished_->pipeline.steps) {
    if (step.enabled) before.push_back(&step);
  }
  const std::size_t i = job.firstChanged;
  const auto rest = static_cast<std::ptrdiff_t>(i + 1);
  if (i >= before.size() || before.size() != job.steps.size() || before[i]->filter != job.steps[i]->filter ||
      before[i]->values.size() != 1 ||
      !std::equal(before.begin() + rest, before.end(), job.steps.begin() + rest,
                  [](const PipelineStep* a, const PipelineStep* b) { return *a == *b; }))
    return;
  const auto found = editPreviews_.find(job.prefixes[i] + std::string(before[i]->filter->name));
  if (found == editPreviews_.end()) return;
  job.changes = found->second->changes(before[i]->values[0], job.steps[i]->values[0]);
}

// What depends on nothing that is new in this run is still true; the rest is made anew, once the result is seen.
void RunController::keepPreviews(const Job& job) {
  EditPreviews kept;
  missing_.clear();
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const PipelineStep& step = *job.steps[i];
    if (step.values.size() != 1) continue;
    const std::string key = job.prefixes[i] + std::string(step.filter->name);
    const EditedStep edited{step.filter->name, step.values[0], job.previews->find(job.prefixes[i]),
                            finished_->result.mesh};
    const auto known = editPreviews_.find(key);
    if (known != editPreviews_.end() && known->second->suits(edited)) {
      kept.insert(*known);
    } else {
      missing_.emplace_back(key, edited);
    }
  }
  editPreviews_ = std::move(kept);
  frameTimer_.start(kFrameWait);
}

// In the background, as long as no run wants the processors.
void RunController::preparePreviews() {
  for (auto& [key, step] : std::exchange(missing_, {})) {
    preparations_.post([this, key, step, context = preparing_, environment = environment_, centre = centre_] {
      std::shared_ptr<const EditPreview> made;
      try {
        context->checkCancelled();
        made = makeEditPreview(step, environment, centre, [&] { context->checkCancelled(); });
      } catch (const std::exception&) {
        return;  // cancelled, or memory ran out: then a run shows the first change
      }
      const auto keep = [this, key, context, made] {
        if (made && context == preparing_) editPreviews_[key] = made;
      };
      QMetaObject::invokeMethod(this, keep, Qt::QueuedConnection);
    });
  }
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
    finished->result = runPipeline(job.environment, job.pipeline, *job.context, &cache);
    outcome.content = makeContent(job, finished->result);
    outcome.finished = std::move(finished);
  } catch (const Cancelled&) {
    outcome = {};
  } catch (const std::bad_alloc&) {
    outcome.error = tr("memory ran out; close other programs or use a smaller environment");
  } catch (const std::exception& error) {
    outcome.error = QString::fromUtf8(error.what());
  }
  return outcome;
}

ViewContent RunController::makeContent(const Job& job, const RunResult& result) {
  ViewContent content;
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const RemovalStyle* style = removalStyle(job.steps[i]->filter->name);
    if (!style || result.steps[i].out.area >= result.steps[i].in.area * kSameArea) continue;  // it removed nothing
    if (!content.firstRemoval) {
      content.firstRemoval = style;
      continue;  // the environment's own floors stand for what was there before
    }
    if (const MeshPtr before = job.previews->find(job.prefixes[i])) {
      content.removed.push_back({style, makeMeshGeometry(*before, job.centre, style->paint)});
    }
  }
  if (result.mesh) content.walkable.push_back(makeMeshGeometry(*result.mesh, job.centre));
  return content;
}

void RunController::scheduleDrain() {
  if (!job_ || drainTimer_.isActive()) return;
  const auto period = waitsForPicture() ? kWatchPeriod : kDrainPeriod;
  const auto due = std::chrono::ceil<std::chrono::milliseconds>(drained_ + period - RunEventBuffer::Clock::now());
  drainTimer_.start(std::max(due, std::chrono::milliseconds(0)));
}

void RunController::drain() {
  if (!job_) return;
  drained_ = RunEventBuffer::Clock::now();
  const std::vector<RunEventBuffer::Step> steps = job_->events->fetch();
  takeStatuses(steps);
  if (!job_) return;  // somebody who heard of them has cancelled
  const std::size_t changed = job_->firstChanged;
  if (job_->changes.empty() && changed < steps.size() && steps[changed].finished) job_->changes = job_->changesOfStep;
  const auto last = job_->lastPicture ? *job_->lastPicture : job_->begun;
  const auto period = job_->changes.empty() ? kPicturePeriod : kDetailPeriod;
  if (waitsForPicture() || RunEventBuffer::Clock::now() - last > period) showParts(steps);
}

void RunController::takeStatuses(const std::vector<RunEventBuffer::Step>& steps) {
  double done = 0;
  QString text = tr("Finishing");
  for (std::size_t i = 0; i < steps.size() && i < job_->ids.size(); ++i) {
    const RunEventBuffer::Step& step = steps[i];
    StepStatus& status = statuses_[job_->ids[i]];
    if (!step.finished) {
      status.state = StepState::Running;
      status.fraction = step.fraction;
      text = QString::fromStdString(std::string(job_->steps[i]->filter->label));
      done += step.fraction;
      continue;
    }
    done += 1;
    const bool current = status.state == StepState::Done || status.state == StepState::Cached;
    if (current && status.prefix == job_->prefixes[i + 1]) continue;
    status.state = StepState::Done;
    status.prefix = job_->prefixes[i + 1];
    if (step.whole.mesh) {
      status.wallMs = milliseconds(step.ended - step.started);
      status.trianglesOut = step.whole.mesh->triangles.size();
    }
  }
  if (drained_ - job_->begun > kProgressAfter) {
    emit progressed(done / static_cast<double>(job_->ids.size() + 1), text);
    emit statusChanged();
  }
}

// Without an earlier result, the steps on the way would only flicker past.
bool RunController::waitsForPicture() const { return shown_.mesh && !job_->lastPicture; }

// The last step that has something to show.
void RunController::showParts(const std::vector<RunEventBuffer::Step>& steps) {
  for (std::size_t i = steps.size(); i-- > 0;) {
    const bool pieces = !steps[i].parts.empty();
    if (!pieces && !steps[i].whole.mesh) continue;
    const std::size_t parts = pieces ? steps[i].parts.size() + 1 : 0;
    if (job_->shownStep == i && job_->shownParts == parts) return;
    job_->shownStep = i;
    job_->shownParts = parts;
    // In front of an earlier result, only what changes it is worth showing, and that once.
    if (!pieces && shown_.mesh && (job_->changes.empty() || job_->lastPicture)) return;
    const ViewContent content = contentOfStep(steps[i]);
    job_->lastPicture = RunEventBuffer::Clock::now();
    provisional_ = true;
    emit contentReady(content);  // last: who hears it may cancel
    return;
  }
}

// In front of the last finished run where there is one, its pieces and what has changed; else its pieces or its whole
// result alone.
ViewContent RunController::contentOfStep(const RunEventBuffer::Step& step) const {
  const bool pieces = !step.parts.empty();
  ViewContent content = shown_.content;
  if (pieces && shown_.mesh) content = withPieces(shown_, step.parts);
  content.changes = job_->changes;
  if (shown_.mesh) return content;
  content.walkable.clear();
  for (const RunEventBuffer::Part& part : step.parts) content.walkable.push_back(part.geometry);
  if (!pieces) content.walkable.push_back(step.whole.geometry);
  return content;
}

void RunController::complete(const std::shared_ptr<Job>& job, const Outcome& outcome) {
  if (job != job_) return;  // cancelled or overtaken
  drained_ = RunEventBuffer::Clock::now();
  takeStatuses(job->events->fetch());  // the last events, which may have come after the timer
  if (job != job_) return;             // somebody who heard of them has cancelled
  job_.reset();
  if (outcome.finished) {
    finished_ = outcome.finished;
    finishedKey_ = job->key;
    shown_ = {finished_->result.mesh, outcome.content};
    const std::vector<StepStatistics>& steps = finished_->result.steps;
    for (std::size_t i = 0; i < steps.size() && i < job->ids.size(); ++i) {
      StepStatus& status = statuses_[job->ids[i]];
      status.state = steps[i].fromCache ? StepState::Cached : StepState::Done;
      status.wallMs = steps[i].wallMs;
      status.trianglesIn = steps[i].in.triangles;
      status.trianglesOut = steps[i].out.triangles;
      status.note = QString::fromStdString(steps[i].note);
      status.prefix = job->prefixes[i + 1];
    }
    provisional_ = false;
    emit statusChanged();
    keepPreviews(*job);
    emit contentReady(outcome.content);
    emit finished();
    return;
  }
  const auto running =
      std::find_if(job->ids.begin(), job->ids.end(), [&](int id) { return statuses_[id].state == StepState::Running; });
  if (running != job->ids.end()) {
    statuses_[*running].state = outcome.error.isEmpty() ? StepState::Cancelled : StepState::Failed;
    statuses_[*running].error = outcome.error;
  }
  showLastResult();
  emit statusChanged();
  if (outcome.error.isEmpty()) {
    emit cancelled();
  } else {
    emit failed(outcome.error);
  }
}

}  // namespace footfall
