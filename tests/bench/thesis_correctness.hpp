// Measures how far a parallel result is from the sequential one (thesis 5.5). Call this in a process of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/thesis_measurement.hpp"

namespace footfall::bench {

/// Compares the second run's result with the first's: `bytes_equal` (of the exports), `sets_equal` (exactly the same
/// points); `areas` of the walkable surface, of both, and `covered`, their ratio; and `distances` from the first to the
/// second, in the environment's units: `samples`, `min`, `max`, `mean`, `rms` and `upper`, which no point of the first
/// surface exceeds.
Json measureCorrectness(const ThesisSubject& subject, const Configuration& first, const Configuration& second);

}  // namespace footfall::bench
