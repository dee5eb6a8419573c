// The resources that this process has used so far, as the operating system counts them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace footfall::detail {

/// CPU time of all threads of the process in milliseconds.
double processCpuMs();

/// The peak of the physical memory of the process, in bytes.
std::uint64_t peakRssBytes();

/// Wall and CPU time since the stopwatch was made.
class Stopwatch {
 public:
  [[nodiscard]] double wallMs() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall_).count();
  }
  [[nodiscard]] double cpuMs() const { return processCpuMs() - cpu_; }

 private:
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  double cpu_ = processCpuMs();
};

}  // namespace footfall::detail
