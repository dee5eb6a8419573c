// Measures the processor time of a run, and how long its threads waited for a processor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "core/base/process_usage.hpp"

namespace footfall::ui {

/// The state of the counters at one moment of a run, in milliseconds.
struct ProcessorSample {
  double atMs = 0;      ///< since the run began
  double cpuMs = 0;     ///< processor time of the process since then
  double waitedMs = 0;  ///< time since then that its threads were ready but no processor was free
};

/// Samples of one run in order of time. Both counters are interpolated linearly between samples.
struct ProcessorUse {
  std::vector<ProcessorSample> samples = {};

  [[nodiscard]] bool known() const { return samples.size() > 1; }
  /// Processor time of the process between two times.
  [[nodiscard]] double cpuMs(double start, double end) const;
  /// Time that threads waited for a processor between two times, because other programs had them or there are more
  /// threads than processors.
  [[nodiscard]] double waitedMs(double start, double end) const;
};

/// Takes samples. Thread-safe. The window's thread is left out, because it belongs to no run. There are no samples
/// where the system does not count waiting times.
class ProcessorWatch {
 public:
  ProcessorWatch();
  void sample();
  [[nodiscard]] ProcessorUse use() const;

 private:
  mutable std::mutex mutex_;
  detail::Stopwatch clock_;
  std::map<int, double> before_;  ///< for each thread, the time that it had waited when the run began
  std::vector<ProcessorSample> samples_;
};

}  // namespace footfall::ui
