// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/background_release.hpp"

#include <condition_variable>
#include <deque>
#include <limits>
#include <mutex>
#include <thread>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace footfall::detail {
namespace {

/// The releaser has a thread of its own, because a TBB worker that picks up one task keeps a processor busy looking for
/// more long afterwards, also where the run may use one thread only.
class Releaser {
 public:
  Releaser() {
    std::thread([this] { work(); }).detach();
  }

  /// Returns false where too much is queued already; otherwise the queue would grow with every run of a quick series.
  bool take(std::shared_ptr<const void>& thing) {
    constexpr std::size_t kMostWaiting = 4;
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= kMostWaiting) return false;
    waiting_.push_back(std::move(thing));
    added_.notify_one();
    return true;
  }

 private:
  [[noreturn]] void work() {
    for (;;) {
      std::shared_ptr<const void> next;
      std::unique_lock lock(mutex_);
      added_.wait(lock, [this] { return !waiting_.empty(); });
      next = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      next = nullptr;
    }
  }

  std::mutex mutex_;
  std::condition_variable added_;
  std::deque<std::shared_ptr<const void>> waiting_;
};

}  // namespace

void releaseInBackground(std::shared_ptr<const void> thing) noexcept {
  try {
    // This object is never destroyed, because the program may end before the last release is done.
    static auto* const releaser = new Releaser;
    releaser->take(thing);
  } catch (...) {  // there is no thread or no memory, so `thing` is freed here
  }
}

void returnFreedMemory() noexcept {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void keepFreedMemory() noexcept {
#ifdef __GLIBC__
  constexpr int kLargestKept = 32 << 20;  // the most that glibc takes on machines of 64 bits
  constexpr int kGrowth = 4 << 20;
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, kGrowth);
#endif
}

}  // namespace footfall::detail
