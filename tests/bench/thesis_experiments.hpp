// The thesis's experiments (5.4 to 5.6), on all environments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/bench/thesis_measurement.hpp"

namespace footfall::bench {

struct ThesisOptions {
  std::vector<ThesisSubject> subjects;
  /// The experiments to run.
  bool due = true, strategies = true, printed = true, scaling = true, correctness = true;
  std::vector<std::string> strategyTexts;  ///< empty: those of the thesis and ours
  std::vector<int> threads;                ///< of the scaling, ascending; those above the processors only take turns
  int tableThreads = 2;                    ///< of strategies and correctness
  Rounds rounds;
  Limits limits{std::chrono::seconds(600), 0};  ///< limits of one measurement
};

/// Measures everything, telling on standard error what it is at. The result has
/// - `program` (`version`), `machine` (describeMachine()), `processors`, `threads`, `table_threads`, `due_threads`,
/// `runs`;
/// - `environments`: a list; each with `name`, `sample` (a boolean), `clearance`, `triangles`, and for the experiments
///   that ran:
///   - `due`: `sequential`, `plain` (without a block) and `auto` of measureTimes(), the last two with two threads;
///   - `strategies`: a list of measureTimes() with `label`, `strategy`, `threads`, `speed_up` over the first one (the
///     same filters on one thread, without a block), `peak_bytes`, and `thesis` (`total_ms`, `speed_up`, phases);
///   - `printed`: `sequential` and `parallel` of measureTimes(), the listings of 5.4 as they are printed, with
///     `speed_up` and the `area` that is left;
///   - `scaling`: `sequential_ms`, and `lines`: each with `label` and `points` (measureTimes() with `threads`,
///     `speed_up`, `efficiency`);
///   - `correctness`: a list of measureCorrectness() with `label`, `metres_per_unit` and `thesis`;
/// - `due`: a list of `environment` (its number), `name`, `triangles`, `what`, `due`, `measured`, `at_least`, `met`.
/// Whatever cannot be measured has `fails` with the reason in the place of its figures.
Json runThesisExperiments(const ThesisOptions& options);

}  // namespace footfall::bench
