// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/step_statuses.hpp"

#include <algorithm>
#include <utility>

#include "ui/base/text/core_text.hpp"

namespace footfall::ui {

StepStatus StepStatuses::find(int id) const {
  const auto found = rows_.find(id);
  return found == rows_.end() ? StepStatus{} : statusOf(id, found->second);
}

StepStatus StepStatuses::statusOf(int id, const Row& row) const {
  StepStatus status;
  const auto shown = shown_.find(id);
  if (shown != shown_.end()) status = shown->second.status;
  status.note.clear();
  if (!row.enabled || skipped_.contains(id)) {
    status.state = row.enabled ? StepState::Skipped : StepState::Off;
    return status;
  }
  if (invalid_ && invalid_->id == id) {
    status.state = StepState::Failed;
    status.error = invalid_->message;
    return status;
  }
  const Attempted* attempted = nullptr;
  if (attempt_) {
    const auto found = attempt_->steps.find(id);
    if (found != attempt_->steps.end()) attempted = &found->second;
  }
  if (attempted && attempt_->underWay && attempted->status.state == StepState::Running) {
    status.state = StepState::Running;
    status.fraction = attempted->status.fraction;
    return status;
  }
  // Equal rows may have changed places, so the steps up to a row count, and not which row it was.
  const auto isHere = [&](const auto& step) { return step.second.prefix == row.prefix; };
  if (const auto here = std::ranges::find_if(shown_, isHere); here != shown_.end()) return here->second.status;
  if (attempt_) {
    const auto here = std::ranges::find_if(attempt_->steps, isHere);
    if (here != attempt_->steps.end() && here->second.status.state == StepState::Done) return here->second.status;
  }
  if (attempted && !attempt_->underWay && attempt_->key == key_) {
    if (attempted->status.state == StepState::Failed || attempted->status.state == StepState::Cancelled) {
      status.state = attempted->status.state;
      status.error = attempted->status.error;
      return status;
    }
    if (attempt_->cancelled) {
      status.state = StepState::Cancelled;
      return status;
    }
  }
  status.state = shown == shown_.end() ? StepState::Fresh : StepState::Stale;
  return status;
}

void StepStatuses::clear() {
  shown_.clear();
  attempt_.reset();
}

void StepStatuses::forgetFigures() {
  for (auto& [id, shown] : shown_) shown.prefix.clear();
  if (!attempt_) return;
  attempt_->key.clear();
  for (auto& [id, step] : attempt_->steps) step.prefix.clear();
}

void StepStatuses::setFilters(const std::vector<FilterEntry>& filters, std::set<int> skipped,
                              std::optional<InvalidStep> invalid) {
  skipped_ = std::move(skipped);
  invalid_ = std::move(invalid);
  rows_.clear();
  key_.clear();
  for (const FilterEntry& entry : filters) {
    if (entry.step.enabled && !skipped_.contains(entry.id)) key_ = extendPrefix(key_, entry.step);
    rows_[entry.id] = {entry.step.enabled, key_};
  }
}

void StepStatuses::begin(const RunJob& job) {
  attempt_.emplace();
  attempt_->key = job.key;
  attempt_->ids = job.ids;
  for (std::size_t i = 0; i < job.ids.size(); ++i) {
    Attempted& step = attempt_->steps[job.ids[i]];
    step.prefix = job.prefixes[i + 1];
    step.status.state = StepState::Stale;
  }
}

void StepStatuses::stop(bool cancelled) {
  if (!attempt_) return;
  attempt_->underWay = false;
  attempt_->cancelled = cancelled;
}

void StepStatuses::fail(const QString& error) {
  if (!attempt_) return;
  attempt_->underWay = false;
  std::vector<StepStatus*> stopped;
  for (const int id : attempt_->ids) {
    StepStatus& status = attempt_->steps[id].status;
    if (status.state == StepState::Running) stopped.push_back(&status);
  }
  for (StepStatus* status : stopped) status->state = StepState::Cancelled;
  if (error.isEmpty()) return;
  // The run ended between two steps, before the next one began.
  for (std::size_t i = 0; stopped.empty() && i < attempt_->ids.size(); ++i) {
    StepStatus& status = attempt_->steps[attempt_->ids[i]].status;
    if (status.state != StepState::Done || i + 1 == attempt_->ids.size()) stopped.push_back(&status);
  }
  if (stopped.empty()) return;
  stopped.front()->state = StepState::Failed;
  stopped.front()->error = error;
}

void StepStatuses::run(std::size_t step, double fraction) {
  if (!attempt_) return;
  StepStatus& status = attempt_->steps[attempt_->ids[step]].status;
  status.state = StepState::Running;
  status.fraction = fraction;
}

void StepStatuses::finish(std::size_t step, const RunEventBuffer::Step& events) {
  if (!attempt_) return;
  StepStatus& status = attempt_->steps[attempt_->ids[step]].status;
  status.state = StepState::Done;
  if (!events.whole.mesh) return;
  status.wallMs = std::chrono::duration<double, std::milli>(events.ended - events.started).count();
  status.trianglesOut = events.whole.mesh->triangles.size();
}

void StepStatuses::setResult(const RunJob& job, const RunResult& result, bool known) {
  attempt_.reset();
  shown_.clear();
  for (std::size_t i = 0; i < result.steps.size() && i < job.ids.size(); ++i) {
    const StepStatistics& step = result.steps[i];
    Shown& shown = shown_[job.ids[i]];
    shown.prefix = job.prefixes[i + 1];
    shown.status.state = known || step.fromCache ? StepState::Cached : StepState::Done;
    shown.status.wallMs = step.wallMs;
    shown.status.trianglesIn = step.in.triangles;
    shown.status.trianglesOut = step.out.triangles;
    shown.status.note = coreText(step.note);
  }
}

}  // namespace footfall::ui
