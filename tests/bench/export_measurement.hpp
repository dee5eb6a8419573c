// Measures the time to write a result, in each format of the table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "tests/bench/sampling.hpp"

namespace footfall::bench {

/// Writes a rough terrain of about `triangles` triangles in two layers, no two of them in one plane, so that formats
/// with polygons can merge few. Gives `triangles` and `formats`: a list of `ending`, `make_ms` (its bytes in memory),
/// `write_ms` (to `folder`, down to the disk; medians) and `bytes`. Without Detour its format is missing. Run this
/// isolated.
Json measureExports(std::uint32_t triangles, const std::string& folder, const Repetition& repetition);

}  // namespace footfall::bench
