// Runs of the thesis's experiments on one environment. To be called in a process of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "tests/bench/isolated.hpp"
#include "tests/bench/thesis_pipelines.hpp"

namespace footfall::bench {
using namespace detail;

/// A way to run an environment.
struct Configuration {
  FilterList filters = FilterList::Own;
  std::string strategy;  ///< empty: no parallel block
  int threads = 1;
};

/// Runs without a cache.
RunResult runConfiguration(const ThesisSubject& subject, const std::shared_ptr<const Environment>& environment,
                           const Configuration& configuration);

/// The number of rounds: at least `runs` unless `mostSeconds` have passed, and more until `leastSeconds` have passed.
struct Rounds {
  int runs = 7;
  double leastSeconds = 2;
  double mostSeconds = 30;
};

/// Runs the configurations in turn, round after round (every other one backwards), after one round for warming up. One
/// entry a configuration: `runs`, and as medians `total_ms`, `cpu_ms` (of all threads), `preprocessing_ms`,
/// `partitioning_ms`, `parallel_ms`, `merging_ms`, `postprocessing_ms`, `overhead_ms` (thesis 5.4), `cut_share`
/// (partitioning and merging over the total) and `imbalance` (of the last block); `triangles` and `area` (in the plan)
/// of the result; `cells`, `made_by` and `reason` of the last block; `bytes_equal`: whether the export is that of the
/// first configuration with the same filters (none for that one itself). What cannot run has `fails` instead.
Json measureTimes(const ThesisSubject& subject, const std::vector<Configuration>& configurations, const Rounds& rounds);

/// `triangles` of the environment, and `peak_bytes` of this process after one run.
Json measureMemory(const ThesisSubject& subject, const Configuration& configuration);

}  // namespace footfall::bench
