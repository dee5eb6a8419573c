// A background thread that runs jobs one after the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace footfall::ui {

/// The thread, and the workers that it starts, have a lower priority than the window's thread where the system has
/// priorities for threads, because software OpenGL draws on the same processors. post() never waits. The destructor
/// waits for the running job (cancel it first), and then drops the jobs that have not begun, or runs them as well. Jobs
/// must not throw.
class BackgroundQueue {
 public:
  enum class AtEnd { DropJobs, FinishJobs };

  explicit BackgroundQueue(AtEnd atEnd = AtEnd::DropJobs);
  ~BackgroundQueue();
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  void post(std::function<void()> job);

 private:
  void work(const std::stop_token& stop);

  AtEnd atEnd_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<std::function<void()>> jobs_;
  std::jthread thread_;  // declared last, because it uses the others
};

}  // namespace footfall::ui
