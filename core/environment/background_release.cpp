// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/background_release.hpp"

#include <oneapi/tbb/task_arena.h>

#include <atomic>

namespace footfall {

void releaseInBackground(std::shared_ptr<const void> thing) noexcept {
  try {
    // An arena without a place for whoever calls: a worker comes even where a run may have one thread only. It is never
    // destroyed, because a program may end before the last task.
    static auto* const arena = new oneapi::tbb::task_arena(1, 0);
    // Runs that follow each other closely keep all workers, and what waits would grow with every run.
    static auto* const waiting = new std::atomic<int>(0);
    constexpr int kMostWaiting = 4;
    if (waiting->load() >= kMostWaiting) return;  // freed here
    waiting->fetch_add(1);
    const auto release = [held = std::move(thing)](const void*) mutable {
      held.reset();
      waiting->fetch_sub(1);
    };
    arena->enqueue([whole = std::shared_ptr<const void>(nullptr, release)] {});  // goes with the task
  } catch (...) {  // no memory for a task: `thing` is freed here
  }
}

}  // namespace footfall
