// Turns SIGINT and SIGTERM into a cancelled run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <thread>

#include "footfall/run_context.hpp"

namespace footfall::app {

/// Makes SIGINT and SIGTERM cancel the context, as long as it lives, instead of ending the process. A thread of its own
/// waits for them, so nothing runs in a signal handler. Make it before other threads: they inherit that the signals are
/// blocked.
class InterruptWatcher {
 public:
  /// Throws std::system_error when the system has no descriptors left.
  explicit InterruptWatcher(RunContext& context);
  ~InterruptWatcher();
  InterruptWatcher(const InterruptWatcher&) = delete;
  InterruptWatcher& operator=(const InterruptWatcher&) = delete;

 private:
  void restore() noexcept;

  sigset_t previousMask_;
  int signals_ = -1;  // signalfd: readable when a signal waits
  int stop_ = -1;     // eventfd: readable when the watcher is to end
  std::thread thread_;
};

}  // namespace footfall::app
