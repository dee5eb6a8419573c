// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/step_statuses.hpp"

#include <utility>

#include "ui/base/core_text.hpp"

namespace footfall::ui {

StepStatus StepStatuses::find(int id) const {
  const auto found = statuses_.find(id);
  return found == statuses_.end() ? StepStatus{} : found->second;
}

void StepStatuses::forgetFigures() {
  for (auto& [id, status] : statuses_) status.prefix.clear();
}

void StepStatuses::follow(const std::vector<FilterEntry>& filters, bool running) {
  std::map<int, StepStatus> kept;
  std::string prefix;
  for (const FilterEntry& entry : filters) {
    StepStatus status = find(entry.id);
    if (!entry.step.enabled) {
      if (status.state != StepState::Off) status = {};
      status.state = StepState::Off;
    } else {
      prefix = extendPrefix(prefix, entry.step);
      if (status.prefix != prefix && !(running && status.state == StepState::Running)) {
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

void StepStatuses::begin() {
  for (auto& [id, status] : statuses_) {
    if (status.state == StepState::Failed) status.state = StepState::Stale;
    status.error.clear();
  }
}

void StepStatuses::stop(const RunJob& job, StepState unfinished) {
  for (const int id : job.ids) {
    StepStatus& status = statuses_[id];
    if (status.state == StepState::Running || status.state == StepState::Fresh || status.state == StepState::Stale)
      status.state = unfinished;
  }
}

void StepStatuses::fail(const RunJob& job, const QString& error) {
  bool told = false;
  for (const int id : job.ids) {
    StepStatus& status = statuses_[id];
    if (status.state != StepState::Running) continue;
    status.state = error.isEmpty() || told ? StepState::Cancelled : StepState::Failed;
    if (!std::exchange(told, true)) status.error = error;
  }
}

void StepStatuses::finish(const RunJob& job, std::size_t step, const RunEventBuffer::Step& events) {
  StepStatus& status = statuses_[job.ids[step]];
  const bool current = status.state == StepState::Done || status.state == StepState::Cached;
  if (current && status.prefix == job.prefixes[step + 1]) return;
  status.state = StepState::Done;
  status.prefix = job.prefixes[step + 1];
  if (!events.whole.mesh) return;
  status.wallMs = std::chrono::duration<double, std::milli>(events.ended - events.started).count();
  status.trianglesOut = events.whole.mesh->triangles.size();
}

void StepStatuses::setResult(const RunJob& job, const RunResult& result, bool known) {
  for (std::size_t i = 0; i < result.steps.size() && i < job.ids.size(); ++i) {
    const StepStatistics& step = result.steps[i];
    StepStatus& status = statuses_[job.ids[i]];
    status.state = known || step.fromCache ? StepState::Cached : StepState::Done;
    status.wallMs = step.wallMs;
    status.trianglesIn = step.in.triangles;
    status.trianglesOut = step.out.triangles;
    status.note = coreText(step.note);
    status.prefix = job.prefixes[i + 1];
  }
}

}  // namespace footfall::ui
