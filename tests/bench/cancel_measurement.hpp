// Measures how long a run goes on after it was cancelled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/pipeline_measurement.hpp"

namespace footfall::bench {

/// Loads the subject and runs the default pipeline on it once to the end and then `moments` times more, each of them
/// cancelled at another moment; these are spread evenly over load and run. What counts is the time from
/// RunContext::cancel() until the exception is with whoever called, all memory freed on the way. Gives `threads`,
/// `triangles`, `whole_ms` (load and run), `moments` (those at which something still ran), `median_ms`, `longest_ms`
/// with `longest_at` (the step) and `longest_cpu_ms` (of all threads, which does not count what others do on the
/// machine), and `late`: for each that took above `due_ms` what step it was in, when, and how long.
Json measureCancelling(const Subject& subject, int threads, int moments);

}  // namespace footfall::bench
