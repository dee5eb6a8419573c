// SPDX-License-Identifier: GPL-3.0-or-later
#include "interruptible.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace footfall::python {
namespace {

namespace py = pybind11;
using namespace std::chrono_literals;

struct StepProgress {
  std::size_t step = 0;
  std::string name;
  double fraction = 0;
};

/// The messages from the worker to the thread that waits for it.
class Messages {
 public:
  /// Called from any thread.
  void add(const RunEvent& event) {
    using Kind = RunEvent::Kind;
    if (event.kind != Kind::StepStarted && event.kind != Kind::Progress && event.kind != Kind::StepFinished) return;
    const std::lock_guard lock(mutex_);
    if (event.kind == Kind::StepStarted) names_[event.step] = event.text;
    StepProgress news{event.step, names_[event.step], event.kind == Kind::StepFinished ? 1 : event.fraction};
    // Only the last progress within a step counts.
    if (event.kind == Kind::Progress && !news_.empty() && news_.back().step == event.step && lastIsProgress_)
      news_.back() = std::move(news);
    else
      news_.push_back(std::move(news));
    lastIsProgress_ = event.kind == Kind::Progress;
  }

  void finish() {
    const std::lock_guard lock(mutex_);
    finished_ = true;
    changed_.notify_one();
  }

  bool waitForEnd(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, most, [this] { return finished_; });
  }

  std::deque<StepProgress> take() {
    const std::lock_guard lock(mutex_);
    lastIsProgress_ = false;
    return std::exchange(news_, {});
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<StepProgress> news_;
  std::map<std::size_t, std::string> names_;
  bool lastIsProgress_ = false;
  bool finished_ = false;
};

void report(const py::object& progress, Messages& messages) {
  if (progress.is_none()) return;
  for (const StepProgress& news : messages.take()) progress(news.step, news.name, news.fraction);
}

}  // namespace

void doInterruptibly(const py::object& progress, const std::function<void(RunContext&)>& work) {
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress: is not callable; give a function of (step, name, fraction), or None");
  Messages messages;
  RunContext context(progress.is_none() ? RunContext::Listener()
                                        : [&messages](const RunEvent& event) { messages.add(event); });
  std::exception_ptr failure, interruption;
  std::thread worker([&] {
    try {
      work(context);
    } catch (...) {
      failure = std::current_exception();
    }
    messages.finish();
  });
  {
    const py::gil_scoped_release unlocked;
    while (!messages.waitForEnd(10ms)) {
      if (interruption) continue;
      const py::gil_scoped_acquire locked;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        report(progress, messages);
      } catch (...) {
        interruption = std::current_exception();
        context.cancel();
      }
    }
    worker.join();
  }
  if (interruption) std::rethrow_exception(interruption);
  if (failure) std::rethrow_exception(failure);
  report(progress, messages);
}

}  // namespace footfall::python
