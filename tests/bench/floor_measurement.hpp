// Measures the least possible work: reading the bytes of the file, and building the fastest tree over the triangles,
// Embree's.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "footfall/environment.hpp"
#include "tests/bench/sampling.hpp"

namespace footfall::bench {

/// Gives `read_ms` (the file into memory), `tree_ms` (rtcCommitScene on triangles that lie ready as floats), `wall_ms`
/// (both) and `runs`. To be run isolated.
Json measureFloor(const std::string& path, const Environment& environment, int threads, const Repetition& repetition);

}  // namespace footfall::bench
