// The thesis's experiments (5.4 to 5.6), on all environments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/bench/thesis_measurement.hpp"

namespace footfall::bench {

struct ThesisOptions {
  std::vector<ThesisSubject> subjects;
  bool due = true, strategies = true, scaling = true, correctness = true;  ///< true: run this experiment
  std::vector<std::string> strategyTexts;                                  ///< empty: those of the thesis and ours
  std::vector<int> threads;         ///< threads of the scaling experiment, ascending, none above the processors
  std::vector<int> threadsLeftOut;  ///< requested numbers of threads that are above the processors
  int tableThreads = 2;             ///< threads for strategies and correctness
  Rounds rounds;
  Limits limits{std::chrono::seconds(600), 0};  ///< limits of one measurement
};

/// The number of threads that can run at the same time.
int processorCount();

/// Measures everything, with progress on standard error. The result has
/// - `program` (`version`), `processors`, `threads`, `threads_left_out`, `table_threads`, `due_threads`, `runs`;
/// - `environments`: a list; each with `name`, `sample` (a boolean), `clearance`, `triangles`, and for the experiments
///   that ran:
///   - `due`: `sequential`, `plain` (without a block) and `auto` of measureTimes(), the last two with two threads;
///   - `strategies`: a list of measureTimes() with `label`, `strategy`, `threads`, `speed_up` over the first one (the
///     same filters on one thread, without a block), `peak_bytes`, and `thesis` (`total_ms`, `speed_up`);
///   - `scaling`: `sequential_ms`, and `lines`: each with `label` and `points` (measureTimes() with `threads`,
///     `speed_up`, `efficiency`);
///   - `correctness`: a list of measureCorrectness() with `label`, `unit_metres` and `thesis`;
/// - `due`: a list of `environment` (its number), `name`, `triangles`, `what`, `due`, `measured`, `at_least`, `met`.
/// Whatever cannot be measured has `fails` with the reason in the place of its figures.
Json runThesisExperiments(const ThesisOptions& options);

}  // namespace footfall::bench
