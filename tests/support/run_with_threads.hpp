// Runs code of the core on a given number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace footfall::test {

/// Runs with exactly this many threads, however few processors there are.
void runWithThreads(int threads, const std::function<void()>& body);

}  // namespace footfall::test
