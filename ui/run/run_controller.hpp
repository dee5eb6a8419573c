// Keeps the result up to date with the filter list: runs pipelines in the background and publishes their progress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "ui/base/background_queue.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/document/document.hpp"
#include "ui/run/ahead_runs.hpp"
#include "ui/run/edit_previews.hpp"
#include "ui/run/finished_runs.hpp"
#include "ui/run/run_display.hpp"
#include "ui/run/run_forecast.hpp"
#include "ui/run/run_job.hpp"
#include "ui/run/step_meshes.hpp"
#include "ui/run/step_statuses.hpp"
#include "ui/view/cell_block.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// Lives on the window's thread and never waits there. Every change cancels the run under way and starts another; a
/// change that leaves the same enabled steps, or goes back to a result that is still known (FinishedRuns), starts none.
/// Where runs take long, one that follows others closely waits until no more come (settle); while a value is dragged
/// and runs are quick, the run under way ends first, so that results follow the mouse. Switched to manual, changes wait
/// for runNow(). What can be told of an edit without a run is told at once, and the run then begins after the frame
/// that shows it (frameShown()), as both want the same processors. Signals come on the window's thread, at most about
/// ten times a second once it has shown something.
class RunController : public QObject {
  Q_OBJECT

 public:
  explicit RunController(QObject* parent = nullptr);
  ~RunController() override;

  /// Sets another environment (null: nothing to run on) and drops all results.
  void setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre);
  /// The same level with something changed (an edit of the one before, so that runs take over what they can): the last
  /// result stays in sight until the next one is there.
  void editEnvironment(std::shared_ptr<const Environment> environment);
  [[nodiscard]] std::shared_ptr<const Environment> environment() const { return environment_; }
  void setFilters(const std::vector<FilterEntry>& filters);
  /// Starts at once, even when nothing has changed (results of steps are still taken from the cache).
  void runNow();
  void cancel();
  /// So many threads at most compute a run from now on (0: as many as the machine has). A result that was computed with
  /// another number is computed again, as its threads and cells are not the same.
  void setThreads(int threads);
  /// Off: edits wait for runNow(); opening an environment runs once all the same. On: what is out of date runs.
  void setAutomatic(bool on);
  [[nodiscard]] bool automatic() const { return automatic_; }
  /// The mouse holds a value, or has let it go.
  void setDragging(bool dragging);
  /// Estimated time until the run under way has finished, from earlier times of the same steps and from their progress;
  /// nothing without a run, or with nothing to go by; milliseconds::max() when a step takes far longer than expected.
  [[nodiscard]] std::optional<std::chrono::milliseconds> remaining() const;
  /// Computes these one after the other, while no run of the list is under way: finishedRunOf() has them then, and a
  /// change to one of them shows it at once. Replaces what was asked for before; none: stops.
  void runAhead(std::vector<Pipeline> pipelines) { ahead_.ask(std::move(pipelines)); }
  /// A result that is still known; null otherwise.
  [[nodiscard]] std::shared_ptr<const FinishedRun> finishedRunOf(const Pipeline& pipeline) const;
  [[nodiscard]] const FinishedRuns& finishedRuns() const { return runs_; }
  /// To be called when the view has shown a frame.
  void frameShown();
  /// What the view needs to draw everything: pictures of what a run has so far come the more seldom for it.
  void setPictureTime(double ms) { display_.setPictureTime(ms); }

  [[nodiscard]] StepStatus status(int id) const { return statuses_.find(id); }
  /// A run is under way.
  [[nodiscard]] bool busy() const { return job_ != nullptr; }
  /// A run waits until edits stop.
  [[nodiscard]] bool settling() const { return job_ && job_->settling; }
  /// The last finished run; null when there is none. It may be older than the filter list.
  [[nodiscard]] std::shared_ptr<const FinishedRun> finishedRun() const { return finished_; }
  /// The states of recent runs on this environment and its edits; for stepStates() of finishedRun(), on any thread.
  [[nodiscard]] std::shared_ptr<ResultCache> cache() const { return cache_; }
  /// Whether an edit of the one parameter of a filter would be shown before the run: it is prepared after each run.
  [[nodiscard]] bool previews(int id) const;
  /// Whether finishedRun() belongs to the filter list as it is.
  [[nodiscard]] bool upToDate() const;

 signals:
  void statusChanged();
  /// A run is under way; not emitted for a run that was overtaken in the same moment.
  void started();
  /// `fraction` of the whole run; `text` names the step. Only of runs that take a while.
  void progressed(double fraction, const QString& text);
  void contentReady(const footfall::ui::ViewContent& content);
  /// Cells of the run under way as they are made and finish, then those of the last finished run. Blocks that it took
  /// from the cache come as they were when they ran.
  void cellsChanged(const footfall::ui::CellBlocks& blocks);
  void finished();
  void failed(const QString& message);
  void cancelled();
  void automaticChanged(bool on);
  /// So many of the pipelines given to runAhead() are done; both the same at the end.
  void aheadChanged(int done, int all);

 private:
  enum class Start { Asked, Edited, Overtaking };  ///< the last: by an edit while a run was under way

  void start(Start why);
  [[nodiscard]] Pipeline pipeline() const;
  [[nodiscard]] std::shared_ptr<RunJob> makeJob(const Pipeline& pipeline) const;
  [[nodiscard]] std::shared_ptr<RunJob> makeEditJob() const;
  bool takeKnown(const std::shared_ptr<RunJob>& job);
  void adopt(const RunJob& job, const RunOutcome& outcome, bool known);
  void work(const std::shared_ptr<RunJob>& job);
  void complete(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome);
  void stopJob(StepState unfinished);
  bool reportInvalidStep();
  void forgetSteps();
  [[nodiscard]] bool letsFinish() const;
  void endSettling();
  void nextAhead();
  void scheduleDrain();
  void drain();
  void takeStatuses(const std::vector<RunEventBuffer::Step>& steps, const std::vector<RunEventBuffer::Block>& blocks);

  std::shared_ptr<const Environment> environment_;
  Vec3 centre_;
  std::vector<FilterEntry> filters_;
  StepStatuses statuses_;
  RunForecast forecast_{statuses_};
  std::shared_ptr<RunJob> job_;
  std::shared_ptr<const FinishedRun> finished_;
  std::string finishedKey_;
  FinishedRuns runs_;
  RunDisplay display_;
  bool automatic_ = true;
  int threads_ = 0;
  bool dragging_ = false;
  bool followUp_ = false;  ///< the list has changed while the run under way was let to finish
  QTimer settleTimer_;
  QTimer drainTimer_;
  RunEventBuffer::Clock::time_point drained_;
  std::shared_ptr<StepMeshes> stepMeshes_;
  std::shared_ptr<ResultCache> cache_;
  EditPreviews editPreviews_;
  QTimer frameTimer_;  ///< ends waiting for a frame that does not come
  AheadRuns ahead_;
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
