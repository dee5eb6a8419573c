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
#include "ui/base/namespaces.hpp"
#include "ui/base/work/background_queue.hpp"
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
#include "ui/view/cells/cell_block.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// Lives on the window's thread and never waits there.
///
/// Every change cancels the present run and starts another. A change that leaves the same enabled steps, or returns to
/// a cached result (FinishedRuns), starts none. Where runs take long, a run after frequent edits waits until they stop
/// (settle). While a value is dragged and runs are quick, the present run ends first, so that results follow the mouse.
/// In manual mode, changes wait for runNow().
///
/// Changes that are known without a run are shown at once. The run then begins after the frame that shows them
/// (frameShown()), because both need the same processors. Data that only explains a result (previews of edits, margins
/// of walls and of ledges) is computed after the frame that shows the result.
///
/// Signals are emitted on the window's thread, at most about ten times a second once a run has shown something.
class RunController : public QObject {
  Q_OBJECT

 public:
  explicit RunController(QObject* parent = nullptr);
  ~RunController() override;

  /// Sets another environment (null: nothing to run on) and drops all results.
  void setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre);
  /// Sets the same level with a change (an edit of the one before, so that runs can reuse states). The last result
  /// stays visible until the next one is ready.
  void editEnvironment(std::shared_ptr<const Environment> environment);
  [[nodiscard]] std::shared_ptr<const Environment> environment() const { return inputs_.environment(); }
  void setFilters(const std::vector<FilterEntry>& filters);
  /// Starts at once, even when nothing has changed (results of steps are still taken from the cache).
  void runNow();
  void cancel();
  /// Sets the largest number of threads of later runs (0: all of the machine). A result with another number is computed
  /// again, because its threads and cells differ.
  void setThreads(int threads);
  /// Sets where the cells of parallel blocks run; results of another place are computed again.
  void setPlace(const RunPlace& place);
  /// Off: edits wait for runNow(), but opening an environment runs once. On: an outdated result is computed.
  void setAutomatic(bool on);
  [[nodiscard]] bool automatic() const { return automatic_; }
  /// Called when the drag of a value begins or ends.
  void setDragging(bool dragging);
  /// Estimated time until the present run has finished, from earlier times of the same steps and from their progress.
  /// Empty without a run, or without a basis; milliseconds::max() when a step takes far longer than expected.
  [[nodiscard]] std::optional<std::chrono::milliseconds> remaining() const { return follower_.remaining(); }
  /// Computes these pipelines one after the other, while no run of the list is under way. finishedRunOf() then has
  /// their results, and a change to one of them shows it at once. Replaces the earlier pipelines; an empty list stops.
  void runAhead(std::vector<Pipeline> pipelines) { ahead_.ask(std::move(pipelines)); }
  /// A cached result; null otherwise.
  [[nodiscard]] std::shared_ptr<const FinishedRun> finishedRunOf(const Pipeline& pipeline) const;
  [[nodiscard]] const FinishedRuns& finishedRuns() const { return runs_; }
  /// Called when the view has shown a frame.
  void frameShown() { schedule_.frameShown(); }
  /// Sets the time that the view needs to draw everything; intermediate pictures of a run become rarer with it.
  void setPictureTime(double ms) { display_.setPictureTime(ms); }

  [[nodiscard]] StepStatus status(int id) const { return statuses_.find(id); }
  /// Returns whether a run is under way.
  [[nodiscard]] bool busy() const { return job_ != nullptr; }
  /// Returns whether a run waits until edits stop.
  [[nodiscard]] bool settling() const { return schedule_.settling(); }
  /// Returns whether the shown margins are not yet divided into those of walls and those of ledges.
  [[nodiscard]] bool seeksMarginKinds() const { return margins_.pending(); }
  /// The last finished run; null when there is none. It may be older than the filter list.
  [[nodiscard]] std::shared_ptr<const FinishedRun> finishedRun() const { return finished_; }
  /// The states of recent runs on this environment and its edits; for stepStates() of finishedRun(), on any thread.
  [[nodiscard]] std::shared_ptr<ResultCache> cache() const { return inputs_.cache(); }
  /// Returns whether an edit of a filter's values has a preview; previews are prepared after each run.
  [[nodiscard]] bool previews(int id) const;
  /// Returns whether finishedRun() belongs to the present filter list.
  [[nodiscard]] bool upToDate() const;

 signals:
  void statusChanged();
  /// Emitted when a run begins; not for a run that was overtaken in the same moment.
  void started();
  /// `fraction` is that of the whole run; `text` names the step. Emitted only for runs that take a while.
  void progressed(double fraction, const QString& text);
  void contentReady(const footfall::ui::ViewContent& content);
  /// Emitted with the cells of the present run as they are made and finish, then with those of the last finished run.
  /// Blocks from the cache have the figures of the run that computed them.
  void cellsChanged(const footfall::ui::CellBlocks& blocks);
  void finished();
  void failed(const QString& message);
  void cancelled();
  void automaticChanged(bool on);
  /// Emitted with the number of finished pipelines of runAhead(); both numbers are equal at the end.
  void aheadChanged(int done, int all);

 private:
  enum class Start { Asked, Edited, Overtaking };  ///< Overtaking: started by an edit while a run was under way

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
  bool followUp_ = false;  ///< the list has changed while the present run was allowed to finish
  EditPreviews editPreviews_;
  MarginKinds margins_;
  AheadRuns ahead_;
  BackgroundQueue queue_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
