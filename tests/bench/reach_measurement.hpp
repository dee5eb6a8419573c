// Measures who can reach whom: how likely two random places are connected, without steps, with them, and beside Recast.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "tests/bench/isolated.hpp"
#include "tests/bench/subject.hpp"

namespace footfall::bench {

/// Runs slopes of 45 degrees and the subject's clearance, without and with a StepFilter of `step` (in the subject's
/// units) and a gap of 0.05 m. Gives `step`, and for `plain` and `steps`: `components` and `share`
/// (Components::connectedShare()); `links`, `run_ms` and `plain_run_ms`.
Json measureReach(const Subject& subject, double step, int threads);

/// Compares with Recast with cells of 0.1 m, heights of 0.05 m and a climb of `step`. Gives `share` (of its own places,
/// each a span of one cell), `places`, `common` (the share of its places that lie within kNear above or below ours),
/// and of pairs of common places the shares that we connect (`ours`), that it connects (`theirs`), that only we do
/// (`only_ours`) and that only it does (`only_theirs`), and `only_theirs_pairs`: of the parts of ours that it joins
/// those whose pairs weigh most, with `share` and a place on each (`from`, `to`, Z up). All places count: nothing is
/// random. Throws as findRecastPlaces(), and std::runtime_error when the program has no Recast.
Json compareReach(const Subject& subject, double step, int threads);

}  // namespace footfall::bench
