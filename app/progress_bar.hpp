// One line on stderr that shows the progress of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

#include "footfall/run_context.hpp"

namespace footfall::app {

/// Thread-safe and quick: worker threads report to it. Draws at most every 50 ms, and nothing when not visible.
class ProgressBar {
 public:
  explicit ProgressBar(bool visible) : visible_(visible) {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Starts again at zero for a task of `steps` steps and an ending; 0 steps: only the ending.
  void begin(const std::string& task, std::size_t steps);
  void show(const RunEvent& event);
  /// Wipes the line.
  void clear();

 private:
  void draw(bool atOnce);

  const bool visible_;
  std::mutex mutex_;
  std::string label_;
  std::size_t steps_ = 0;
  std::size_t finished_ = 0;
  double fraction_ = 0;  // fraction of the step under way
  bool drawn_ = false;
  std::chrono::steady_clock::time_point lastDrawn_;
};

}  // namespace footfall::app
