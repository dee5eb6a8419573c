// Measures the peer that is exact but throw-away: a program of its own, which prints its time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/pipeline_measurement.hpp"

namespace footfall::bench {

/// Runs `PROGRAM ENV.obj CLEARANCE /dev/null THREADS` again and again and reads the milliseconds after "TOTAL" from its
/// output: from the file to the walkable environment, in OBJ with Y up. Gives `wall_ms`, `peak_bytes` and `runs`, or
/// `fails`.
Json measurePrototype(const std::string& program, const Subject& subject, int threads, const Repetition& repetition);

}  // namespace footfall::bench
