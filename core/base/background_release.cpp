// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/background_release.hpp"

#include <oneapi/tbb/task_arena.h>

#include <atomic>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace footfall::detail {

void releaseInBackground(std::shared_ptr<const void> thing) noexcept {
  try {
    // An arena without a place for whoever calls: a worker comes even where a run may have one thread only. It is never
    // destroyed, because a program may end before the last task.
    static auto* const arena = new oneapi::tbb::task_arena(1, 0);
    // Runs that follow each other closely keep all workers, and what waits would grow with every run.
    static auto* const waiting = new std::atomic<int>(0);
    constexpr int kMostWaiting = 4;
    if (waiting->load() >= kMostWaiting) return;  // freed here
    // The task alone holds the thing. A reference that is also in an object of this function, if only for the time of a
    // copy, may be the last one when the worker is quick, or this thread is slow.
    auto held = std::make_unique<std::shared_ptr<const void>>(std::move(thing));
    arena->enqueue([whole = held.get()] {
      delete whole;
      waiting->fetch_sub(1);
    });
    waiting->fetch_add(1);
    static_cast<void>(held.release());  // the task's since it was enqueued
  } catch (...) {                       // no memory for a task: `thing` is freed here
  }
}

void returnFreedMemory() noexcept {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace footfall::detail
