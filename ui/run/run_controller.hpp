// Keeps the result up to date with the filter list: runs pipelines in the background and publishes their progress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
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
#include "ui/run/margin_kinds.hpp"
#include "ui/run/run_display.hpp"
#include "ui/run/run_follower.hpp"
#include "ui/run/run_forecast.hpp"
#include "ui/run/run_inputs.hpp"
#include "ui/run/run_job.hpp"
#include "ui/run/run_schedule.hpp"
#include "ui/run/step_statuses.hpp"
#include "ui/view/cell_block.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// Lives on the window's thread and never waits there. Every change cancels the run under way and starts another; a
/// change that leaves the same enabled steps, or goes back to a result that is still known (FinishedRuns), starts none.
/// Where runs take long, one that follows others closely waits until no more come (settle); while a value is dragged
/// and runs are quick, the run under way ends first, so that results follow the mouse. Switched to manual, changes wait
/// for runNow(). What can be told of an edit without a run is told at once, and the run then begins after the frame
/// that shows it (frameShown()), as both want the same processors. What only explains a result (previews of edits,
/// which margins are of walls and which of ledges) is found behind the frame that shows it. Signals come on the
/// window's thread, at most about ten times a second once it has shown something.
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
  [[nodiscard]] std::shared_ptr<const Environment> environment() const { return inputs_.environment(); }
  void setFilters(const std::vector<FilterEntry>& filters);
  /// Starts at once, even when nothing has changed (results of steps are still taken from the cache).
  void runNow();
  void cancel();
  /// So many threads at most compute a run from now on (0: as many as the machine has). A result that was computed with
  /// another number is computed again, as its threads and cells are not the same.
  void setThreads(int threads);
  /// The same of where the cells of parallel blocks are run.
  void setPlace(const RunPlace& place);
  /// Off: edits wait for runNow(); opening an environment runs once all the same. On: what is out of date runs.
  void setAutomatic(bool on);
  [[nodiscard]] bool automatic() const { return automatic_; }
  /// The mouse holds a value, or has let it go.
  void setDragging(bool dragging);
  /// Estimated time until the run under way has finished, from earlier times of the same steps and from their progress;
  /// nothing without a run, or with nothing to go by; milliseconds::max() when a step takes far longer than expected.
  [[nodiscard]] std::optional<std::chrono::milliseconds> remaining() const { return follower_.remaining(); }
  /// Computes these one after the other, while no run of the list is under way: finishedRunOf() has them then, and a
  /// change to one of them shows it at once. Replaces what was asked for before; none: stops.
  void runAhead(std::vector<Pipeline> pipelines) { ahead_.ask(std::move(pipelines)); }
  /// A result that is still known; null otherwise.
  [[nodiscard]] std::shared_ptr<const FinishedRun> finishedRunOf(const Pipeline& pipeline) const;
  [[nodiscard]] const FinishedRuns& finishedRuns() const { return runs_; }
  /// To be called when the view has shown a frame.
  void frameShown() { schedule_.frameShown(); }
  /// What the view needs to draw everything: pictures of what a run has so far come the more seldom for it.
  void setPictureTime(double ms) { display_.setPictureTime(ms); }

  [[nodiscard]] StepStatus status(int id) const { return statuses_.find(id); }
  /// A run is under way.
  [[nodiscard]] bool busy() const { return job_ != nullptr; }
  /// A run waits until edits stop.
  [[nodiscard]] bool settling() const { return schedule_.settling(); }
  /// What is shown of the last result tells borders, but not yet walls from ledges.
  [[nodiscard]] bool seeksMarginKinds() const { return margins_.pending(); }
  /// The last finished run; null when there is none. It may be older than the filter list.
  [[nodiscard]] std::shared_ptr<const FinishedRun> finishedRun() const { return finished_; }
  /// The states of recent runs on this environment and its edits; for stepStates() of finishedRun(), on any thread.
  [[nodiscard]] std::shared_ptr<ResultCache> cache() const { return inputs_.cache(); }
  /// Whether an edit of a filter's values would be shown before the run: it is prepared after each run.
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
  [[nodiscard]] std::shared_ptr<RunJob> makeEditJob() const;
  bool showKnown(const std::shared_ptr<RunJob>& job);
  void showFinished(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome, bool known);
  void work();
  void complete(const std::shared_ptr<RunJob>& job, const RunOutcome& outcome);
  void fail(const QString& error);
  void stopJob(bool cancelled);
  void listProblems();
  bool reportInvalidStep();
  void forgetSteps();
  [[nodiscard]] bool letsFinish() const;
  void explainResult();
  void showMarginKinds(const RunOutcome& outcome, const std::string& key);
  void nextAhead();

  RunInputs inputs_;
  StepStatuses statuses_;
  RunForecast forecast_{statuses_};
  RunDisplay display_;
  RunFollower follower_{statuses_, forecast_, display_};
  RunSchedule schedule_;
  std::shared_ptr<RunJob> job_;
  std::shared_ptr<const FinishedRun> finished_;
  std::string finishedKey_;
  FinishedRuns runs_;
  bool automatic_ = true;
  bool dragging_ = false;
  bool followUp_ = false;  ///< the list has changed while the run under way was let to finish
  EditPreviews editPreviews_;
  MarginKinds margins_;
  AheadRuns ahead_;
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
