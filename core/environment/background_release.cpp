// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/background_release.hpp"

#include <oneapi/tbb/task_arena.h>

namespace footfall {

void releaseInBackground(std::shared_ptr<const void> thing) noexcept {
  try {
    // An arena without a place for whoever calls: a worker comes even where a run may have one thread only. It is never
    // destroyed, because a program may end before the last task.
    static auto* const arena = new oneapi::tbb::task_arena(1, 0);
    arena->enqueue([held = std::move(thing)] {});  // goes with the task
  } catch (...) {                                  // no memory for a task: `thing` is freed here
  }
}

}  // namespace footfall
