// The statuses of the steps of a filter list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/run/run_inputs.hpp"
#include "ui/run/run_job.hpp"
#include "ui/run/step_status.hpp"

namespace footfall::ui {

/// The statuses of all filters of the list, by FilterEntry::id. They depend on the present state of four things, and
/// not on history: the list, the shown result, the present run (or the last one that did not finish), and the errors of
/// the list itself. The first condition that applies decides the status of a row:
///
/// 1. It is switched off, or skipped, or prevents the list from running.
/// 2. The present run is computing it.
/// 3. The shown result has the same steps up to it: the row has that result's figures.
/// 4. The run has computed the same steps up to it: the row has the run's figures.
/// 5. The last run was of this very list and ended early: the row failed or was cancelled.
/// 6. The shown result had this row in another state: it is out of date, with the figures of that result.
/// 7. It has not run yet.
class StepStatuses {
 public:
  [[nodiscard]] StepStatus find(int id) const;
  /// Called when there is no environment: nothing has run.
  void clear();
  /// Called when the environment has changed: figures of the shown result no longer belong to it.
  void forgetFigures();
  /// Sets the present list, the rows that a run leaves out, and the row that prevents the list from running.
  void setFilters(const std::vector<FilterEntry>& filters, std::set<int> skipped, std::optional<InvalidStep> invalid);
  /// Called when a run begins. An earlier run that did not finish is dropped.
  void begin(const RunJob& job);
  /// Called when the present run was ended early; `cancelled`: by the user, else by an edit.
  void stop(bool cancelled);
  /// Called when the present run was cancelled, or failed with `error`. Steps of a block run at the same time; the
  /// first of them gets the error.
  void fail(const QString& error);
  void run(std::size_t step, double fraction);
  void finish(std::size_t step, const RunEventBuffer::Step& events);
  /// Called when a run has finished and its result is shown; `known`: it was cached.
  void setResult(const RunJob& job, const RunResult& result, bool known);

 private:
  struct Attempted {
    StepStatus status;  ///< Running, Done or, before it began, Stale
    std::string prefix;
  };
  /// The present run, or one that did not finish.
  struct Attempt {
    std::string key;
    bool underWay = true;
    bool cancelled = false;
    std::map<int, Attempted> steps;
    std::vector<int> ids;
  };
  struct Shown {
    StepStatus status;
    std::string prefix;  ///< empty: result of another environment
  };

  /// A row of the present list.
  struct Row {
    bool enabled = true;
    std::string prefix;  ///< the steps up to this one
  };

  [[nodiscard]] StepStatus statusOf(int id, const Row& row) const;

  std::map<int, Row> rows_;
  std::string key_;  ///< all steps that run
  std::set<int> skipped_;
  std::optional<InvalidStep> invalid_;
  std::map<int, Shown> shown_;
  std::optional<Attempt> attempt_;
};

}  // namespace footfall::ui
