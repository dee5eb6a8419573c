// SPDX-License-Identifier: GPL-3.0-or-later
// RunController's sense of time: when an edit runs, and how long a run may still take.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/run/run_job.hpp"

namespace footfall::ui {
namespace {

// Runs that take no longer follow every edit, and every step of a drag: people see no wait.
constexpr double kLiveMs = 150;
// So long after the last edit a slow run begins, where edits follow each other; about the pause between two keys.
constexpr auto kSettle = std::chrono::milliseconds(300);

}  // namespace

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

bool RunController::settling() const { return job_ && job_->settling; }

void RunController::endSettling() {
  settleTimer_.stop();
  if (job_ && std::exchange(job_->settling, false)) work(job_);
}

std::optional<double> RunController::expectedOf(const Job& job, std::size_t step) const {
  if (const auto known = stepTimes_.find(job.prefixes[step + 1])) return known;
  return step < job.ids.size() ? status(job.ids[step]).wallMs : std::nullopt;  // with other values
}

// Steps before the first change come from the cache.
double RunController::expectedTime(const Job& job) const {
  std::vector<StepTime> times;
  for (std::size_t i = job.firstChanged; i < job.steps.size(); ++i) times.push_back({expectedOf(job, i), 0, 0, false});
  return expectedMs(times) + (finished_ ? finished_->result.finishMs : 0);
}

std::chrono::milliseconds RunController::settleTime(const Job& job, Start why) const {
  const bool follows = why == Start::Overtaking || (why == Start::Edited && dragging_);
  return follows && expectedTime(job) > kLiveMs ? kSettle : std::chrono::milliseconds(0);
}

bool RunController::letsFinish() const {
  return dragging_ && automatic_ && job_ && !job_->settling && expectedTime(*job_) <= kLiveMs;
}

// What the list as it is would change, before any run of it.
void RunController::showEdit() {
  if (!shown_.mesh) return;
  Pipeline pipeline;
  for (const FilterEntry& entry : filters_) pipeline.steps.push_back(entry.step);
  const std::shared_ptr<Job> job = makeJob(pipeline);
  findFirstChange(*job);
  preview(*job);
  provisional_ = true;
  ViewContent content = shown_.content;
  content.changes = job->changes;
  emit contentReady(content);
}

void RunController::takeTime(std::size_t step, const RunEventBuffer::Step& events, bool inBlock, double fraction) {
  std::vector<StepTime>& times = job_->times;
  if (times.empty()) {
    for (std::size_t i = 0; i < job_->steps.size(); ++i) times.push_back({expectedOf(*job_, i), 0, 0, false});
    if (finished_) times.push_back({finished_->result.finishMs, 0, 0, false});
  }
  StepTime& time = times[step];
  const auto until = events.finished ? events.ended : drained_;
  time.elapsedMs = std::max(0.0, std::chrono::duration<double, std::milli>(until - events.started).count());
  // Filters of a block share the time of their cells.
  if (inBlock && time.expectedMs) time.elapsedMs = fraction * *time.expectedMs;
  time.fraction = fraction;
  time.finished = events.finished;
}

std::optional<std::chrono::milliseconds> RunController::remaining() const {
  if (!job_ || job_->settling) return std::nullopt;
  const auto left = remainingMs(job_->times);
  if (!left) return std::nullopt;
  if (!std::isfinite(*left)) return std::chrono::milliseconds::max();
  const std::chrono::duration<double, std::milli> since = RunEventBuffer::Clock::now() - drained_;
  return std::chrono::milliseconds(static_cast<long long>(std::max(0.0, *left - since.count())));
}

}  // namespace footfall::ui
