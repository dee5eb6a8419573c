// What is known about the steps of a filter list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/run/run_job.hpp"
#include "ui/run/step_status.hpp"

namespace footfall::ui {

/// The statuses of all filters of the list, by FilterEntry::id.
class StepStatuses {
 public:
  [[nodiscard]] StepStatus find(int id) const;
  StepStatus& operator[](int id) { return statuses_[id]; }
  void clear() { statuses_.clear(); }
  /// No figures belong to what will run next.
  void forgetFigures();
  /// An edit of the list makes out of date only what comes after it. `running`: steps that run are left alone.
  void follow(const std::vector<FilterEntry>& filters, bool running);
  /// A run begins: nothing has failed.
  void begin();
  /// A run was ended before its time; its steps that have not ended become `unfinished`.
  void stop(const RunJob& job, StepState unfinished);
  /// A run was cancelled, or failed with `error`. Steps of a block run at the same time: the first of them stands for
  /// what went wrong.
  void fail(const RunJob& job, const QString& error);
  /// A step of a run under way has finished.
  void finish(const RunJob& job, std::size_t step, const RunEventBuffer::Step& events);
  /// A run has finished; `known`: it was known already.
  void setResult(const RunJob& job, const RunResult& result, bool known);

 private:
  std::map<int, StepStatus> statuses_;
};

}  // namespace footfall::ui
