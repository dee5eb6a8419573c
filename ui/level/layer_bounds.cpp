// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/layer_bounds.hpp"

#include <chrono>

#include "core/base/worker_arena.hpp"
#include "footfall/inspect.hpp"

namespace footfall::ui {
namespace {

constexpr std::chrono::milliseconds kRestAfterRun{300};

}  // namespace

LayerBounds::LayerBounds(RunController& controller, LayerPanel& panel)
    : QObject(&panel), controller_(controller), panel_(panel) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestAfterRun);
  connect(&rest_, &QTimer::timeout, this, &LayerBounds::find);
  const auto findSoon = [this] { rest_.start(); };
  connect(&controller_, &RunController::finished, this, findSoon);
  connect(&controller_, &RunController::cancelled, this, findSoon);
  connect(&controller_, &RunController::failed, this, findSoon);
  connect(&panel_, &LayerPanel::appeared, this, &LayerBounds::find);
  connect(&controller_, &RunController::started, this, [this] {
    rest_.stop();
    if (!work_.busy()) return;
    work_.stop();
    run_.reset();
  });
}

void LayerBounds::find() {
  const std::shared_ptr<const FinishedRun> run = controller_.finishedRun();
  if (!run || run == run_.lock() || !panel_.isVisible()) return;
  run_ = run;
  work_.stop();
  if (run->result.mesh->layerCount == 0) return;
  const auto look = [run](RunContext&) {
    return onThreads(1, [&](int) {
      const NavigationMesh& mesh = *run->result.mesh;
      return LayerCounts{mesh.connections.size(), leastLayers(mesh), leastConnections(mesh)};
    });
  };
  // Memory ran out: the list has no bounds.
  work_.start(
      *this, look, [this](const LayerCounts& counts) { panel_.setCounts(counts); }, [](const std::exception&) {});
}

}  // namespace footfall::ui
