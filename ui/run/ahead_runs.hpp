// Computes results that may be needed next, while the list needs no run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "ui/base/work/background_queue.hpp"
#include "ui/run/finished_runs.hpp"
#include "ui/run/run_job.hpp"

namespace footfall::ui {

/// Runs pipelines one after the other and stores their results in `runs`. A run that fails is left out; it fails again,
/// with its message, when the user starts it.
class AheadRuns : public QObject {
  Q_OBJECT

 public:
  /// Makes the job of a pipeline; null: not now.
  using MakeJob = std::function<std::shared_ptr<RunJob>(const Pipeline& pipeline)>;

  AheadRuns(FinishedRuns& runs, BackgroundQueue& queue, MakeJob makeJob);
  ~AheadRuns() override { interrupt(); }

  /// Replaces the pipelines that are still to run; an empty list stops.
  void ask(std::vector<Pipeline> pipelines);
  /// Continues, unless a run is under way already.
  void next();
  /// Ends the present run; next() starts it again.
  void interrupt();

 signals:
  /// Emitted with the number of finished pipelines; both numbers are equal at the end.
  void changed(int done, int all);

 private:
  void complete(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome);
  void emitChanged();

  FinishedRuns& runs_;
  BackgroundQueue& queue_;
  MakeJob makeJob_;
  std::vector<Pipeline> pipelines_;  ///< pipelines still to run
  int all_ = 0;
  std::shared_ptr<RunJob> job_;
};

}  // namespace footfall::ui
