// The machine that figures were measured on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// As many threads can run at the same time.
int processorCount();

/// `processor` (its name), `processors`, `memory_bytes`, `system`, and `load`: how many other processes wanted a
/// processor in the last minute. What the system does not say is null.
Json describeMachine();

}  // namespace footfall::bench
