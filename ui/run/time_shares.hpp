// Where the time of a pipeline goes, step by step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/run/step_status.hpp"

namespace footfall::ui {

struct TimeShare {
  int id = 0;  ///< of the FilterEntry
  QString label;
  double ms = 0;     ///< when the step was last computed
  double share = 0;  ///< of all steps, in [0, 1]
};

struct TimeShares {
  std::vector<TimeShare> steps;  ///< in the order of the list; those that are on and have been computed
  double totalMs = 0;            ///< what a run without the cache takes
};

/// Filters in a parallel block have their share of the time that the cells took.
TimeShares timeShares(const std::vector<FilterEntry>& filters, const std::function<StepStatus(int)>& statusOf);
/// Null for steps without a time.
const TimeShare* shareOf(const TimeShares& shares, int id);
/// "82 ms: Vertical clearance 61 %, Layer subdivision 12 %, ...", the longest first; empty without times.
QString timeSummary(const TimeShares& shares);

}  // namespace footfall::ui
