// Measures paths for a radius: between random places, on the corridor map, beside paths behind a RadiusFilter.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/isolated.hpp"
#include "tests/bench/subject.hpp"

namespace footfall::bench {

/// Lengths are in metres.
struct PathPairs {
  int pairs = 0;
  double radius = 0.3;
  double step = 0.4;
  double longest = 1.01;  ///< a path on the map is at most as many times as long as that behind the filter
};

/// Runs slopes of 45 degrees, the subject's clearance, the step and an area of 2 m2, without and with a RadiusFilter,
/// and finds paths between random pairs of places behind the filter. Gives
/// - `pairs`, `triangles` (of the area without the filter), `map_ms`: until paths can be found;
/// - `found`: pairs with a path on the map and one behind the filter; `none`: pairs with neither; `between`: pairs with
///   one on the map alone, and with none there for 1.02 radii, as the tolerance of the filter allows;
/// - claims that failed: `missing` (a path behind the filter, none on the map), `surplus` (one on the map for 1.02
///   radii, none behind the filter), `longer` (the path on the map is too long) and `shorter` (that for 1.02 radii is
///   too short);
/// - `longest` and `shortest`: the length on the map over that behind the filter, in the plan;
/// - `median_ms` and `most_ms`: processor time of a path on the map, of pairs with a path behind the filter; the latter
///   is that of 99 %.
/// The caller runs it isolated.
Json measurePaths(const Subject& subject, const PathPairs& asked, int threads);

/// The table of the list `paths` of runBenchmark().
std::string formatPaths(const Json& results);

/// Writes the claims that failed to standard error after the name of the program. Returns the exit code: 1 when there
/// are any.
int reportFailedClaims(const std::string& program, const Json& results);

}  // namespace footfall::bench
