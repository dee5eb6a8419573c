// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/ahead_runs.hpp"

#include <utility>

namespace footfall::ui {

AheadRuns::AheadRuns(FinishedRuns& runs, BackgroundQueue& queue, MakeJob makeJob)
    : runs_(runs), queue_(queue), makeJob_(std::move(makeJob)) {}

void AheadRuns::ask(std::vector<Pipeline> pipelines) {
  interrupt();
  job_.reset();
  if (pipelines.empty() && all_ == 0) return;
  all_ = static_cast<int>(pipelines.size());
  pipelines_ = std::move(pipelines);
  emitChanged();
  next();
}

void AheadRuns::interrupt() {
  if (job_) job_->context->cancel();
}

void AheadRuns::next() {
  if (job_) return;
  const std::size_t before = pipelines_.size();
  while (!pipelines_.empty() && runs_.peek(keyOf(pipelines_.front()))) pipelines_.erase(pipelines_.begin());
  std::shared_ptr<RunJob> job = pipelines_.empty() ? nullptr : makeJob_(pipelines_.front());
  if (job) {
    keepStepMeshes(*job);  // the pictures of removed triangles need them
    job_ = job;
    queue_.post([this, job] {
      const auto outcome = std::make_shared<RunOutcome>(compute(*job));
      QMetaObject::invokeMethod(
          this, [this, job, outcome] { complete(job, *outcome); }, Qt::QueuedConnection);
    });
  }
  if (before != pipelines_.size()) emitChanged();
}

void AheadRuns::complete(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome) {
  if (job != job_) return;  // the job was replaced
  job_.reset();
  if (outcome.finished) runs_.store(job->key, outcome.finished, outcome.content);
  const bool interrupted = !outcome.finished && outcome.error.isEmpty();
  if (!interrupted && !pipelines_.empty()) {
    pipelines_.erase(pipelines_.begin());
    emitChanged();
  }
  next();
}

void AheadRuns::emitChanged() { emit changed(all_ - static_cast<int>(pipelines_.size()), all_); }

}  // namespace footfall::ui
