// Where the threads of a run leave what they have to tell until the window fetches it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "core/pipeline/run_context.hpp"

namespace footfall {

/// Thread-safe. However fast events come, the owner is called once and then not again before it has fetched.
class RunEventBuffer {
 public:
  using Clock = std::chrono::steady_clock;

  struct Step {
    bool finished = false;
    Clock::time_point started, ended;
    double fraction = 0;
    std::shared_ptr<const NavigationMesh> whole;               ///< its result; empty for cached steps
    std::vector<std::shared_ptr<const NavigationMesh>> parts;  ///< pieces, while it runs
  };

  /// `notify` is called from the threads of the run and must be quick and thread-safe.
  explicit RunEventBuffer(std::function<void()> notify) : notify_(std::move(notify)) {}

  void add(const RunEvent& event);
  /// All steps so far, in order; the last one may be running.
  std::vector<Step> fetch();

 private:
  std::function<void()> notify_;
  std::mutex mutex_;
  std::vector<Step> steps_;
  bool notified_ = false;
};

}  // namespace footfall
