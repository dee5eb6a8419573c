// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/cancelled_run.hpp"

#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/process_usage.hpp"
#include "footfall/errors.hpp"
#include "footfall/run.hpp"

namespace footfall::test {

using detail::processCpuMs;
using namespace std::chrono_literals;

namespace {

std::optional<double> cancelOnce(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                                 std::size_t step, double afterMs) {
  std::atomic<double> started{-1};
  RunContext context([&](const RunEvent& event) {
    if (event.kind == RunEvent::Kind::StepStarted && event.step == step) started = processCpuMs();
  });
  std::atomic<bool> isOver{false};
  double told = 0;
  std::thread canceller([&] {
    while (!isOver && (started < 0 || processCpuMs() < started + afterMs)) std::this_thread::sleep_for(1ms);
    told = processCpuMs();
    context.cancel();
  });
  std::optional<double> known;
  try {
    runPipeline(environment, pipeline, context, nullptr, 1);
  } catch (const Cancelled&) {
    known = processCpuMs();
  }
  isOver = true;
  canceller.join();
  return known ? std::optional(*known - told) : std::nullopt;
}

}  // namespace

double stepCpuMs(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline, std::size_t step) {
  double started = 0, finished = 0;
  RunContext context([&](const RunEvent& event) {
    if (event.step != step) return;
    if (event.kind == RunEvent::Kind::StepStarted) started = processCpuMs();
    if (event.kind == RunEvent::Kind::StepFinished) finished = processCpuMs();
  });
  runPipeline(environment, pipeline, context, nullptr, 1);
  return finished - started;
}

std::optional<double> cpuMsAfterCancelling(const std::shared_ptr<const Environment>& environment,
                                           const Pipeline& pipeline, std::size_t step, double afterMs) {
  for (int attempt = 0; attempt < 20; ++attempt)
    if (const auto known = cancelOnce(environment, pipeline, step, afterMs)) return known;
  return std::nullopt;
}

}  // namespace footfall::test
