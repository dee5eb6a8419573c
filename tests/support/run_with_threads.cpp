// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/run_with_threads.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>

namespace footfall::test {

void runWithThreads(int threads, const std::function<void()>& body) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena(threads).execute(body);
}

}  // namespace footfall::test
