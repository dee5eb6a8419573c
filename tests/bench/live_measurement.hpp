// Measures the cost of an edit of a level when the results of earlier runs are at hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/pipeline_measurement.hpp"

namespace footfall::bench {

/// Measures runs of the default pipeline with the cache of the runs before: a pillar of 100 triangles comes, is moved
/// about the walkable area and goes (the making of the edited environment counts); the slope goes up by a degree; the
/// clearance grows by a twentieth. Gives `triangles`, `full_ms` (from nothing, with an empty cache), `obstacle_ms`,
/// `obstacle_most_ms`, `slope_ms`, `clearance_ms` (medians, except the most) and `edits`, the number of edits of the
/// obstacle. To be run isolated.
Json measureLive(const Subject& subject, int threads, const Repetition& repetition);

}  // namespace footfall::bench
