// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/corridors/corridor_watch.hpp"

#include <exception>
#include <new>
#include <utility>

#include "core/base/worker_arena.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/run/without_radius.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kMostLines = 60'000;  // overlays are sent to the graphics card with every frame

ShownCorridors makeShown(const FinishedRun& run, ResultCache* cache, RunContext& context) {
  ShownCorridors shown;
  shown.isWithoutRadius = hasRadius(run.pipeline);
  shown.map = makeCorridorMap(*meshWithoutRadius(run, cache, context), {}, &context);
  const BottleneckRule rule = usualBottlenecks(run.environment->metresPerUnit);
  shown.slit = rule.widerThan;
  shown.list = listBottlenecks(shown.map, rule);
  shown.lines = makeCorridorLines(shown.map, shown.slit, kMostLines);
  return shown;
}

}  // namespace

CorridorWatch::CorridorWatch(RunController& controller, QObject* parent) : QObject(parent), controller_(controller) {
  connect(&controller_, &RunController::started, this, &CorridorWatch::pause);
  for (const auto ended : {&RunController::finished, &RunController::cancelled})
    connect(&controller_, ended, this, &CorridorWatch::refresh);
  connect(&controller_, &RunController::failed, this, &CorridorWatch::refresh);
}

void CorridorWatch::setWanted(bool wanted) {
  if (wanted == isWanted_) return;
  isWanted_ = wanted;
  refresh();
}

// The run needs the processors, and its result replaces the map.
void CorridorWatch::pause() {
  if (work_.busy()) {
    work_.stop();
    run_.reset();
  }
  if (isWanted_) emit changed();
}

void CorridorWatch::refresh() {
  const std::shared_ptr<const FinishedRun> run = isWanted_ ? controller_.finishedRun() : nullptr;
  if (!run) {
    work_.stop();
    run_.reset();
    if (std::exchange(shown_, nullptr) || isWanted_) emit changed();
    return;
  }
  if (run == run_) {
    emit changed();
    return;
  }
  run_ = run;
  work_.start(
      *this,
      [run, cache = controller_.cache()](RunContext& context) {
        return onThreads(
            0, [&](int) { return std::make_shared<const ShownCorridors>(makeShown(*run, cache.get(), context)); });
      },
      [this](const std::shared_ptr<const ShownCorridors>& shown) {
        shown_ = shown;
        emit changed();
      },
      [this](const std::exception& error) {
        shown_.reset();
        emit changed();
        emit failed(dynamic_cast<const std::bad_alloc*>(&error) != nullptr
                        ? tr("The corridors: memory ran out; close other programs or use a smaller environment")
                        : coreText(error));
      });
  emit changed();
}

}  // namespace footfall::ui
