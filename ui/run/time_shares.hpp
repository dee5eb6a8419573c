// The shares of a pipeline's steps in its time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/run/step_status.hpp"

namespace footfall::ui {

struct TimeShare {
  int id = 0;  ///< id of the FilterEntry
  QString label;
  double ms = 0;     ///< time when the step was last computed
  double share = 0;  ///< share of all steps' time, in [0, 1]
};

struct TimeShares {
  std::vector<TimeShare> steps;  ///< in the order of the list; enabled steps that have been computed
  double totalMs = 0;            ///< time of a run without the cache
};

/// Filters in a parallel block have their share of the cells' time.
TimeShares timeShares(const std::vector<FilterEntry>& filters, const std::function<StepStatus(int)>& statusOf);
/// The share of a step; null for steps without a time.
const TimeShare* shareOf(const TimeShares& shares, int id);
/// A summary, the longest steps first: "82 ms: Vertical clearance 61 %, Layer subdivision 12 %, ..."; empty without
/// times.
QString timeSummary(const TimeShares& shares);

}  // namespace footfall::ui
