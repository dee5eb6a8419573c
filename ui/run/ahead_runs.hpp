// Results that nobody has asked for yet, computed while the list needs no run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "ui/base/background_queue.hpp"
#include "ui/run/finished_runs.hpp"
#include "ui/run/run_job.hpp"

namespace footfall::ui {

/// Runs of pipelines, one after the other; their results are in `runs` then. One that fails is left out: it fails
/// again when it is asked for, and says why.
class AheadRuns : public QObject {
  Q_OBJECT

 public:
  /// Makes the job of a pipeline; null: not now.
  using MakeJob = std::function<std::shared_ptr<RunJob>(const Pipeline& pipeline)>;

  AheadRuns(FinishedRuns& runs, BackgroundQueue& queue, MakeJob makeJob);
  ~AheadRuns() override { interrupt(); }

  /// Replaces what was asked for before; none: stops.
  void ask(std::vector<Pipeline> pipelines);
  /// Goes on, unless one is under way already.
  void next();
  /// The one under way ends, and comes again with next().
  void interrupt();

 signals:
  /// So many of what was asked for are done; both the same at the end.
  void changed(int done, int all);

 private:
  void complete(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome);
  void emitChanged();

  FinishedRuns& runs_;
  BackgroundQueue& queue_;
  MakeJob makeJob_;
  std::vector<Pipeline> pipelines_;  ///< still to be computed
  int all_ = 0;
  std::shared_ptr<RunJob> job_;
};

}  // namespace footfall::ui
