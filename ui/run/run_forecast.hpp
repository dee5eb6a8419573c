// How long a run takes, from earlier times of the same steps and from its progress.
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

  /// Takes the times of a finished run.
  void remember(const RunJob& job, const RunResult& result);
  /// What steps took belongs to another environment.
  void forgetSteps() { steps_.clear(); }
  void clear();
  /// The time of what is not in the cache: the steps from the first change on; milliseconds.
  [[nodiscard]] double expectedTime(const RunJob& job) const;
  /// A step of the job under way, as it was told at `now`. `inBlock`: filters of a block share the time of their cells.
  void take(RunJob& job, std::size_t step, const RunEventBuffer::Step& events, bool inBlock, double fraction,
            Clock::time_point now) const;
  /// Until the job has finished, which was last told of at `told`; nothing where there is nothing to go by;
  /// milliseconds::max() when a step takes far longer than expected.
  [[nodiscard]] static std::optional<std::chrono::milliseconds> remaining(const RunJob& job, Clock::time_point told);

 private:
  [[nodiscard]] std::optional<double> expectedOf(const RunJob& job, std::size_t step) const;

  const StepStatuses& statuses_;
  StepTimes steps_;
  std::optional<double> finishMs_;  ///< of the last finished run
};

}  // namespace footfall::ui
