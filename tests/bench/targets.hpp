// Holds the targets, and judges whether they are met.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// Judges results as runBenchmark() returns them, at the last of their thread counts. Returns a list of `against`,
/// `what`, `due` and `measured` (numbers), `unit`, `at_least` (a due figure is a lower bound), `met` and `where` (the
/// worst case, when the figure is one). Figures that were not measured have no entry; failed ones have null for
/// `measured`.
Json judgeTargets(const Json& results);

/// The entry of a list of measurements that belongs to a thread count; null when there is none or it failed.
const Json* atThreads(const Json& list, int threads);

/// The exponents of time and memory (what the process held above its start) between neighbouring sizes of one
/// growth series: a list of `series`, `from`, `to`, `time` and `memory`.
Json growthExponents(const Json& results);

}  // namespace footfall::bench
