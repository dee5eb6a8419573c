// SPDX-License-Identifier: GPL-3.0-or-later
// RunController's work ahead: results that nobody has asked for yet, while the list needs no run.
#include <utility>

#include "ui/run/run_job.hpp"

namespace footfall::ui {

std::shared_ptr<const FinishedRun> RunController::finishedRunOf(const Pipeline& pipeline) const {
  std::string key;
  for (const PipelineStep& step : pipeline.steps) {
    if (step.enabled) key = extendPrefix(key, step);
  }
  return runs_.peek(key);
}

void RunController::runAhead(std::vector<Pipeline> pipelines) {
  if (aheadJob_) aheadJob_->context->cancel();
  aheadJob_.reset();
  if (pipelines.empty() && aheadAll_ == 0) return;
  aheadAll_ = static_cast<int>(pipelines.size());
  ahead_ = std::move(pipelines);
  emit aheadChanged(0, aheadAll_);
  nextAhead();
}

void RunController::nextAhead() {
  if (job_ || aheadJob_ || !environment_) return;
  const std::size_t before = ahead_.size();
  while (!ahead_.empty() && finishedRunOf(ahead_.front())) ahead_.erase(ahead_.begin());
  const auto tell = [this] { emit aheadChanged(aheadAll_ - static_cast<int>(ahead_.size()), aheadAll_); };
  if (ahead_.empty()) {
    if (before > 0) tell();
    return;
  }
  const std::shared_ptr<Job> job = makeJob(ahead_.front());
  Job* const raw = job.get();
  job->context = std::make_unique<RunContext>(
      [raw](const RunEvent& event) {
        // For the pictures of what was removed.
        if (event.kind == RunEvent::Kind::StepFinished && event.part && event.step + 1 < raw->prefixes.size())
          raw->previews->store(raw->prefixes[event.step + 1], event.part);
      },
      true);
  aheadJob_ = job;
  queue_.post([this, job, cache = cache_] {
    const auto outcome = std::make_shared<Outcome>(compute(*job, *cache));
    QMetaObject::invokeMethod(
        this, [this, job, outcome] { completeAhead(job, *outcome); }, Qt::QueuedConnection);
  });
  if (before != ahead_.size()) tell();
}

// One that a run of the list has interrupted comes again; one that has failed fails when it is asked for, and says why.
void RunController::completeAhead(const std::shared_ptr<Job>& job, const Outcome& outcome) {
  if (job != aheadJob_) return;  // nobody wants it any more
  aheadJob_.reset();
  if (outcome.finished) runs_.store(job->key, outcome.finished, outcome.content);
  const bool interrupted = !outcome.finished && outcome.error.isEmpty();
  if (!interrupted && !ahead_.empty()) {
    ahead_.erase(ahead_.begin());
    emit aheadChanged(aheadAll_ - static_cast<int>(ahead_.size()), aheadAll_);
  }
  nextAhead();
}

}  // namespace footfall::ui
