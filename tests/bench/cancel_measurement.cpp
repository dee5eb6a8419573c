// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/cancel_measurement.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/process_usage.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

constexpr double kDueMs = 50;

struct Latency {
  double atMs = 0;
  double wallMs = 0;
  double cpuMs = 0;
  std::string step;
};

/// The progress of a run, reported by its threads.
class Progress {
 public:
  void set(std::string step) {
    const std::lock_guard lock(mutex_);
    step_ = std::move(step);
  }
  [[nodiscard]] std::string step() const {
    const std::lock_guard lock(mutex_);
    return step_;
  }

 private:
  mutable std::mutex mutex_;
  std::string step_ = "load";
};

/// Cancels a run after a time, on a thread of its own, unless the run ends before.
class Canceller {
 public:
  Canceller(RunContext& context, const Progress& progress, double afterMs)
      : thread_([this, &context, &progress, afterMs] {
          std::unique_lock lock(mutex_);
          if (ended_.wait_for(lock, std::chrono::duration<double, std::milli>(afterMs), [this] { return isOver_; }))
            return;
          step_ = progress.step();
          since_.emplace();
          context.cancel();
        }) {}
  ~Canceller() { end(); }
  Canceller(const Canceller&) = delete;
  Canceller& operator=(const Canceller&) = delete;

  /// The latency since it was cancelled; nothing if the run was quicker.
  std::optional<Latency> end() {
    std::optional<Latency> latency;
    {
      const std::lock_guard lock(mutex_);
      isOver_ = true;
      if (since_) latency = {0, since_->wallMs(), since_->cpuMs(), step_};
    }
    ended_.notify_all();
    if (thread_.joinable()) thread_.join();
    return latency;
  }

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool isOver_ = false;
  std::string step_;
  std::optional<Stopwatch> since_;
  std::thread thread_;  // last: it uses the others
};

void loadAndRun(const Subject& subject, int threads, RunContext& context) {
  ImportOptions options;
  options.metresPerUnit = subject.metresPerUnit();
  const auto environment = importEnvironment(subject.path, options, &context);
  runPipeline(environment, pipelineFor(subject, *environment), context, nullptr, threads);
}

RunContext::Listener listenerOf(Progress& progress) {
  return [&progress](const RunEvent& event) {
    if (event.kind == RunEvent::Kind::StepStarted) progress.set(event.text);
    if (event.kind == RunEvent::Kind::StepFinished) progress.set("after step " + std::to_string(event.step + 1));
  };
}

std::optional<Latency> cancelAfter(const Subject& subject, int threads, double ms) {
  Progress progress;
  RunContext context(listenerOf(progress));
  Canceller canceller(context, progress, ms);
  try {
    loadAndRun(subject, threads, context);
  } catch (const Cancelled&) {
    auto latency = canceller.end();
    if (latency) latency->atMs = ms;
    return latency;
  }
  return std::nullopt;
}

}  // namespace

Json measureCancelling(const Subject& subject, int threads, int moments) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const auto triangles = loadSubject(subject)->triangles.size();
  const Stopwatch whole;
  RunContext uninterrupted;
  loadAndRun(subject, threads, uninterrupted);
  const double wholeMs = whole.wallMs();

  // On a busy machine the thread that cancels may be late each time.
  constexpr int kAttempts = 5;
  std::vector<Latency> latencies;
  for (int i = 0; i < moments || (latencies.empty() && i < moments * kAttempts); ++i)
    if (auto latency = cancelAfter(subject, threads, wholeMs * (i % moments + 0.5) / moments))
      latencies.push_back(std::move(*latency));
  Json json{{"threads", threads},
            {"triangles", triangles},
            {"whole_ms", wholeMs},
            {"due_ms", kDueMs},
            {"moments", latencies.size()}};
  if (latencies.empty()) return {{"fails", "every run ended before it was cancelled"}};
  std::vector<double> walls;
  for (const Latency& latency : latencies) walls.push_back(latency.wallMs);
  const auto& longest = *std::ranges::max_element(latencies, {}, &Latency::wallMs);
  json["median_ms"] = median(walls);
  json["longest_ms"] = longest.wallMs;
  json["longest_at"] = longest.step;
  json["longest_cpu_ms"] = std::ranges::max_element(latencies, {}, &Latency::cpuMs)->cpuMs;
  json["late"] = Json::array();
  for (const Latency& latency : latencies) {
    if (latency.wallMs <= kDueMs) continue;
    json["late"].push_back(
        {{"step", latency.step}, {"at_ms", latency.atMs}, {"wall_ms", latency.wallMs}, {"cpu_ms", latency.cpuMs}});
  }
  return json;
}

}  // namespace footfall::bench
