// The machine that figures were measured on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// The number of threads that can run at the same time.
int processorCount();

/// `processor` (its name), `processors`, `memory_bytes`, `system`, and `load`: the number of other processes that
/// needed a processor in the last minute. Values that the system does not report are null.
Json describeMachine();

}  // namespace footfall::bench
