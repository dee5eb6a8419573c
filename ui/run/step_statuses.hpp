// What is known about the steps of a filter list.
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

/// The statuses of all filters of the list, by FilterEntry::id. They are a function of four things and of nothing that
/// happened before: the list as it is, the result that is shown, the run under way (or the last one that did not
/// finish), and the errors that the list itself has. Each row takes the first of these that applies:
///
/// 1. It is switched off, or skipped, or the list cannot run because of it.
/// 2. The run under way computes it.
/// 3. The shown result has the same steps up to it: the row has that result's figures.
/// 4. The run has computed the same steps up to it: its figures.
/// 5. The last run was of this very list and ended before its time: the row failed or was cancelled.
/// 6. The shown result had this row in another state: it is out of date, with the figures of that result.
/// 7. It has not run yet.
class StepStatuses {
 public:
  [[nodiscard]] StepStatus find(int id) const;
  /// No environment: nothing has run.
  void clear();
  /// The environment has changed: figures of the shown result do not belong to it any more.
  void forgetFigures();
  /// The list as it is, the rows that a run leaves out, and the row that keeps the list from running.
  void setFilters(const std::vector<FilterEntry>& filters, std::set<int> skipped, std::optional<InvalidStep> invalid);
  /// A run begins. An earlier run that did not finish is forgotten.
  void begin(const RunJob& job);
  /// The run under way was ended before its time; `cancelled`: by the user, else by an edit.
  void stop(bool cancelled);
  /// The run under way was cancelled, or failed with `error`. Steps of a block run at the same time: the first of them
  /// has the error.
  void fail(const QString& error);
  void run(std::size_t step, double fraction);
  void finish(std::size_t step, const RunEventBuffer::Step& events);
  /// A run has finished and its result is shown; `known`: it was known already.
  void setResult(const RunJob& job, const RunResult& result, bool known);

 private:
  struct Attempted {
    StepStatus status;  ///< Running, Done or, before it began, Stale
    std::string prefix;
  };
  /// A run under way, or one that did not finish.
  struct Attempt {
    std::string key;
    bool underWay = true;
    bool cancelled = false;
    std::map<int, Attempted> steps;
    std::vector<int> ids;
  };
  struct Shown {
    StepStatus status;
    std::string prefix;  ///< empty: of another environment
  };

  /// A row of the list as it is.
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
