// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/background_queue.hpp"

#include <utility>

namespace footfall {

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
  while (true) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return !jobs_.empty(); })) return;  // stopped, and nothing is left
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
  }
}

}  // namespace footfall
