// Follows the present run, for the list and the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "ui/run/run_display.hpp"
#include "ui/run/run_forecast.hpp"
#include "ui/run/run_job.hpp"
#include "ui/run/step_statuses.hpp"

namespace footfall::ui {

/// Fetches the events of a run, at most about ten times a second once it has shown something, and updates the statuses
/// of its steps, the forecast and the display. Receivers of its signals may end the run.
class RunFollower : public QObject {
  Q_OBJECT

 public:
  RunFollower(StepStatuses& statuses, RunForecast& forecast, RunDisplay& display);

  /// Begins to follow a run; sets the job's buffer of events.
  void follow(const std::shared_ptr<RunJob>& job);
  /// Ends following the run.
  void leave() { job_.reset(); }
  /// Fetches the last events of a run that has ended.
  void fetchLast();
  /// Estimated time until the run has ended; see RunForecast::remaining().
  [[nodiscard]] std::optional<std::chrono::milliseconds> remaining() const;

 signals:
  void statusChanged();
  /// `fraction` is that of the whole run; `text` names the step. Emitted only for runs that take a while.
  void progressed(double fraction, const QString& text);

 private:
  void scheduleFetch();
  void fetch();
  void takeStatuses(const std::vector<RunEventBuffer::Step>& steps, const std::vector<RunEventBuffer::Block>& blocks);

  StepStatuses& statuses_;
  RunForecast& forecast_;
  RunDisplay& display_;
  std::shared_ptr<RunJob> job_;  ///< null: no run is under way
  QTimer timer_;
  RunEventBuffer::Clock::time_point fetched_;
};

}  // namespace footfall::ui
