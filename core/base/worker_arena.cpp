// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/worker_arena.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

using Arena = oneapi::tbb::task_arena;

// Arenas are kept between uses. With TBB 2021.8, a new arena that begins where another has just ended may get no
// workers for a long time, and loading and two runs follow each other at once. The arenas are never destroyed, because
// a run may last longer than static objects.
class KeptArena {
 public:
  explicit KeptArena(int workers) : workers_(workers) {
    Idle& kept = idle();
    const std::lock_guard lock(kept.mutex);
    auto& arenas = kept.arenas[workers];
    if (arenas.empty()) {
      arena_ = std::make_unique<Arena>(workers);
    } else {
      arena_ = std::move(arenas.back());
      arenas.pop_back();
    }
  }
  ~KeptArena() {
    Idle& kept = idle();
    try {
      const std::lock_guard lock(kept.mutex);
      kept.arenas[workers_].push_back(std::move(arena_));
    } catch (const std::exception&) {  // there is no memory to keep the arena
    }
  }
  KeptArena(const KeptArena&) = delete;
  KeptArena& operator=(const KeptArena&) = delete;

  Arena& operator*() { return *arena_; }

 private:
  struct Idle {
    std::mutex mutex;
    std::map<int, std::vector<std::unique_ptr<Arena>>> arenas;  // by number of workers
  };
  static Idle& idle() {
    static auto* const kept = new Idle;
    return *kept;
  }

  int workers_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace

void runOnThreads(int threads, const std::function<void(int)>& work) {
  if (threads < 0 || threads > kMostThreads)
    throw InputError(FOOTFALL_TEXT("%1 threads are out of range; give 1 to %2, or 0 for as many as the machine has"),
                     std::to_string(threads), std::to_string(kMostThreads));
  const int workers = threads > 0 ? threads : machineThreads();
  // The arena bounds the threads of this work, whatever other work runs; the control allows more threads than
  // processors.
  const ThreadLimit limit(workers);
  KeptArena arena(workers);
  (*arena).execute([&] { work(workers); });
}

struct ThreadLimit::Control {
  oneapi::tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(new Control{{oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}}) {
}
ThreadLimit::~ThreadLimit() = default;

int machineThreads() { return std::max(1, oneapi::tbb::info::default_concurrency()); }

int allowedThreads() {
  using Control = oneapi::tbb::global_control;
  return static_cast<int>(Control::active_value(Control::max_allowed_parallelism));
}

int availableThreads() { return oneapi::tbb::this_task_arena::max_concurrency(); }

int threadNumber() { return oneapi::tbb::this_task_arena::current_thread_index(); }

}  // namespace footfall::detail
