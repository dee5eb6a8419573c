// How much of the processors a run had, and how long its threads waited for one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "core/base/process_usage.hpp"

namespace footfall::ui {

/// The state of the counters at one moment of a run; milliseconds.
struct ProcessorSample {
  double atMs = 0;      ///< since the run began
  double cpuMs = 0;     ///< processor time of the process since then
  double waitedMs = 0;  ///< time that its threads could have run since then, but no processor was free
};

/// Samples of one run in order of time. Between two samples, both counters are taken to grow evenly.
struct ProcessorUse {
  std::vector<ProcessorSample> samples = {};

  [[nodiscard]] bool known() const { return samples.size() > 1; }
  /// Processor time of the process between two times.
  [[nodiscard]] double cpuMs(double start, double end) const;
  /// Time that threads waited for a processor between two times: other programs had them, or there are more threads
  /// than processors.
  [[nodiscard]] double waitedMs(double start, double end) const;
};

/// Takes samples. Thread-safe. The window's thread is left out: it belongs to no run. Where the system does not count
/// the waiting of threads, there are no samples.
class ProcessorWatch {
 public:
  ProcessorWatch();
  void sample();
  [[nodiscard]] ProcessorUse use() const;

 private:
  mutable std::mutex mutex_;
  detail::Stopwatch clock_;
  std::map<int, double> before_;  ///< for each thread, what it had waited when the run began
  std::vector<ProcessorSample> samples_;
};

}  // namespace footfall::ui
