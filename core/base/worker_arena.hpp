// Limits on the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>

namespace footfall::detail {

/// The most threads that a run may have. TBB ends the process when it is given far more.
inline constexpr int kMostThreads = 1024;

/// Calls `work(n)` where parallel loops use at most n threads: `threads`, or as many as the machine has when that is 0.
/// A number above that of the machine's processors makes more threads. Exceptions pass through. Throws InputError for a
/// number of threads that is negative or above kMostThreads. Thread-safe.
void runOnThreads(int threads, const std::function<void(int)>& work);

/// Runs work that returns a value.
template <class Work>
auto onThreads(int threads, Work&& work) {
  std::optional<std::invoke_result_t<Work, int>> result;
  runOnThreads(threads, [&](int workers) { result.emplace(work(workers)); });
  return std::move(*result);
}

/// Limits the threads of the whole process while it lives; the lowest of several limits counts.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// The threads that the machine runs at a time; at least 1.
int machineThreads();
/// The number of threads that limits leave to the process.
int allowedThreads();
/// The largest number of threads that parallel loops of the calling thread use.
int availableThreads();
/// The calling thread's number among those, from 0 on.
int threadNumber();

}  // namespace footfall::detail
