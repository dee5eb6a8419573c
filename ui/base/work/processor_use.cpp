// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/work/processor_use.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#ifdef __linux__
#include <unistd.h>
#endif

namespace footfall::ui {
namespace {

double interpolate(const std::vector<ProcessorSample>& samples, double at, double ProcessorSample::*value) {
  const auto after = std::ranges::lower_bound(samples, at, {}, &ProcessorSample::atMs);
  if (after == samples.begin()) return samples.front().*value;
  if (after == samples.end()) return samples.back().*value;
  const ProcessorSample& before = *(after - 1);
  const double length = after->atMs - before.atMs;
  const double part = length > 0 ? (at - before.atMs) / length : 1;
  return before.*value + part * ((*after).*value - before.*value);
}

// How long each thread but the first has waited for a processor. /proc/PID/task/TID/schedstat has processor time,
// waiting time and time slices, in nanoseconds. Empty where the system does not report it.
std::map<int, double> waitedOfThreads() {
  std::map<int, double> waited;
#ifdef __linux__
  std::error_code error;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", error)) {
    const std::string name = thread.path().filename().string();
    int id = 0;
    std::from_chars(name.data(), name.data() + name.size(), id);
    if (id == 0 || id == static_cast<int>(getpid())) continue;
    std::ifstream file(thread.path() / "schedstat");
    double ran = 0, waitedNs = 0;
    if (file >> ran >> waitedNs) waited[id] = waitedNs / 1e6;
  }
#endif
  return waited;
}

}  // namespace

double ProcessorUse::cpuMs(double start, double end) const {
  if (!known()) return 0;
  return std::max(
      0.0, interpolate(samples, end, &ProcessorSample::cpuMs) - interpolate(samples, start, &ProcessorSample::cpuMs));
}

double ProcessorUse::waitedMs(double start, double end) const {
  if (!known()) return 0;
  return std::max(0.0, interpolate(samples, end, &ProcessorSample::waitedMs) -
                           interpolate(samples, start, &ProcessorSample::waitedMs));
}

ProcessorWatch::ProcessorWatch() : before_(waitedOfThreads()) {
  if (!before_.empty()) samples_.push_back({});
}

void ProcessorWatch::sample() {
  const std::lock_guard lock(mutex_);
  if (samples_.empty()) return;
  ProcessorSample sample{clock_.wallMs(), clock_.cpuMs(), 0};
  for (const auto& [thread, waited] : waitedOfThreads()) {
    const auto before = before_.find(thread);
    sample.waitedMs += waited - (before == before_.end() ? 0 : before->second);
  }
  // Ended threads are no longer counted, but the time that they waited stays.
  sample.waitedMs = std::max(sample.waitedMs, samples_.back().waitedMs);
  samples_.push_back(sample);
}

ProcessorUse ProcessorWatch::use() const {
  const std::lock_guard lock(mutex_);
  return {samples_};
}

}  // namespace footfall::ui
