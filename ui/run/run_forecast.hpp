// Estimates the time of a run from earlier times of the same steps and from its progress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>

#include "ui/run/run_job.hpp"
#include "ui/run/step_statuses.hpp"
#include "ui/run/step_times.hpp"

namespace footfall::ui {

class RunForecast {
 public:
  using Clock = RunEventBuffer::Clock;

  explicit RunForecast(const StepStatuses& statuses) : statuses_(statuses) {}

  /// Stores the times of a finished run.
  void remember(const RunJob& job, const RunResult& result);
  /// Times of steps belong to one environment.
  void forgetSteps() { steps_.clear(); }
  void clear();
  /// The expected time of steps that are not in the cache, from the first change on, in milliseconds.
  [[nodiscard]] double expectedTime(const RunJob& job) const;
  /// Sets the state of a step of the present job at the time `now`. `inBlock`: filters of a block share the time of
  /// their cells.
  void take(RunJob& job, std::size_t step, const RunEventBuffer::Step& events, bool inBlock, double fraction,
            Clock::time_point now) const;
  /// The time until the job has finished, whose last state is of the time `told`. Empty without a basis;
  /// milliseconds::max() when a step takes far longer than expected.
  [[nodiscard]] static std::optional<std::chrono::milliseconds> remaining(const RunJob& job, Clock::time_point told);

 private:
  [[nodiscard]] std::optional<double> expectedOf(const RunJob& job, std::size_t step) const;

  const StepStatuses& statuses_;
  StepTimes steps_;
  std::optional<double> finishMs_;  ///< of the last finished run
};

}  // namespace footfall::ui
