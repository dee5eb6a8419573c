// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/work/background_queue.hpp"

#include <cstdio>
#include <exception>
#include <utility>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace footfall::ui {
namespace {

// Lowers the priority of this thread, so that it gets a third of the window's share where both need the same processor.
// Threads that it starts inherit the priority.
void giveWayToTheWindow() {
#ifdef __linux__
  constexpr int kNicer = 5;
  const auto self = static_cast<id_t>(gettid());  // Linux has a priority for each thread
  setpriority(PRIO_PROCESS, self, getpriority(PRIO_PROCESS, self) + kNicer);
#endif
}

}  // namespace

BackgroundQueue::BackgroundQueue(AtEnd atEnd)
    : atEnd_(atEnd), thread_([this](const std::stop_token& stop) { work(stop); }) {}

BackgroundQueue::~BackgroundQueue() {
  {
    const std::scoped_lock lock(mutex_);
    if (atEnd_ == AtEnd::DropJobs) jobs_.clear();
  }
  thread_.request_stop();
}

void BackgroundQueue::post(std::function<void()> job) {
  {
    const std::scoped_lock lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_one();
}

void BackgroundQueue::work(const std::stop_token& stop) {
  giveWayToTheWindow();
  while (true) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return !jobs_.empty(); })) return;  // the queue was stopped and is empty
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    try {
      job();
    } catch (const std::exception& error) {
      // The job should have reported this itself; the program and the next jobs go on.
      std::fprintf(stderr, "footfall-editor: a job in the background ended early (%s)\n", error.what());
    }
  }
}

}  // namespace footfall::ui
