// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/load_measurement.hpp"

#include <algorithm>
#include <numeric>

#include "ui/base/text/core_text.hpp"
#include "ui/run/known_blocks.hpp"
#include "ui/run/run_job.hpp"

namespace footfall::ui {
namespace {

// A run whose phases are sampled, cancelled with `outer`.
MeasuredRun measure(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline, int threads,
                    RunContext& outer) {
  outer.checkCancelled();
  MeasuredRun run;
  ProcessorWatch watch;
  RunContext* inside = nullptr;
  RunContext context([&](const RunEvent& event) {
    if (outer.cancelled()) inside->cancel();
    using Kind = RunEvent::Kind;
    if (event.kind == Kind::StepStarted || event.kind == Kind::StepFinished || event.kind == Kind::CellsMade)
      watch.sample();
  });
  inside = &context;
  run.result = runPipeline(environment, pipeline, context, nullptr, threads);
  watch.sample();
  run.processors = watch.use();
  run.result.mesh = nullptr;
  return run;
}

}  // namespace

Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  return {values[(values.size() - 1) / 2], values.front(), values.back()};
}

std::size_t medianRun(const std::vector<MeasuredRun>& runs) {
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return runs[i].result.totalMs; });
  return order.empty() ? 0 : order[(order.size() - 1) / 2];
}

CellBlocks blocksOf(const MeasuredRun& run) {
  CellBlocks blocks;
  const auto figures = std::make_shared<const RunFigures>(figuresOfRun(run.result, run.processors));
  for (const BlockReport& report : run.result.blocks) {
    blocks.push_back({report, std::vector<char>(report.cells.size(), 1), figures});
    blocks.back().origin = CellBlock::Origin::Measured;
  }
  return blocks;
}

LoadMeasurement::LoadMeasurement(QObject* parent) : QObject(parent) {}

void LoadMeasurement::start(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, int threads,
                            int count) {
  runs_.clear();
  const int number = ++number_;
  work_.start(
      *this,
      [this, number, environment = std::move(environment), pipeline = withoutSkipped(pipeline), threads,
       count](RunContext& context) {
        std::vector<MeasuredRun> runs;
        for (int i = 0; i < count; ++i) {
          QMetaObject::invokeMethod(
              this,
              [this, number, i, count] {
                if (number == number_ && busy()) emit progressed(i, count);
              },
              Qt::QueuedConnection);
          runs.push_back(measure(environment, pipeline, threads, context));
        }
        return runs;
      },
      [this](const std::vector<MeasuredRun>& runs) {
        runs_ = runs;
        emit finished();
      },
      [this](const std::exception& error) { emit failed(coreText(error)); });
  emit progressed(0, count);
}

void LoadMeasurement::stop() {
  if (!busy()) return;
  work_.stop();
  emit ended();
}

void LoadMeasurement::clear() {
  const bool any = busy() || !runs_.empty();
  work_.stop();
  runs_.clear();
  if (any) emit ended();
}

}  // namespace footfall::ui
