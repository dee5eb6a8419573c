// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_forecast.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::ui {

void RunForecast::remember(const RunJob& job, const RunResult& result) {
  steps_.remember(result.steps, job.prefixes);
  finishMs_ = result.finishMs;
}

void RunForecast::clear() {
  steps_.clear();
  finishMs_.reset();
}

std::optional<double> RunForecast::expectedOf(const RunJob& job, std::size_t step) const {
  if (const auto known = steps_.find(job.prefixes[step + 1])) return known;
  return step < job.ids.size() ? statuses_.find(job.ids[step]).wallMs : std::nullopt;  // time with other values
}

double RunForecast::expectedTime(const RunJob& job) const {
  std::vector<StepTime> times;
  for (std::size_t i = job.firstChanged; i < job.steps.size(); ++i) times.push_back({expectedOf(job, i), 0, 0, false});
  return expectedMs(times) + finishMs_.value_or(0);
}

void RunForecast::take(RunJob& job, std::size_t step, const RunEventBuffer::Step& events, bool inBlock, double fraction,
                       Clock::time_point now) const {
  std::vector<StepTime>& times = job.times;
  if (times.empty()) {
    for (std::size_t i = 0; i < job.steps.size(); ++i) times.push_back({expectedOf(job, i), 0, 0, false});
    if (finishMs_) times.push_back({finishMs_, 0, 0, false});
  }
  StepTime& time = times[step];
  const auto until = events.finished ? events.ended : now;
  time.elapsedMs = std::max(0.0, std::chrono::duration<double, std::milli>(until - events.started).count());
  if (inBlock && time.expectedMs) time.elapsedMs = fraction * *time.expectedMs;
  time.fraction = fraction;
  time.finished = events.finished;
}

std::optional<std::chrono::milliseconds> RunForecast::remaining(const RunJob& job, Clock::time_point told) {
  const auto left = remainingMs(job.times);
  if (!left) return std::nullopt;
  if (!std::isfinite(*left)) return std::chrono::milliseconds::max();
  const std::chrono::duration<double, std::milli> since = Clock::now() - told;
  return std::chrono::milliseconds(static_cast<long long>(std::max(0.0, *left - since.count())));
}

}  // namespace footfall::ui
