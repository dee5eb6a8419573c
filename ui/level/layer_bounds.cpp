// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/layer_bounds.hpp"

#include "core/base/worker_arena.hpp"
#include "footfall/inspect.hpp"

namespace footfall::ui {

LayerBounds::LayerBounds(RunController& controller, LayerPanel& panel)
    : QObject(&panel), controller_(controller), panel_(panel) {
  connect(&controller_, &RunController::finished, this, &LayerBounds::find);
  connect(&controller_, &RunController::cancelled, this, &LayerBounds::find);
  connect(&controller_, &RunController::failed, this, &LayerBounds::find);
  connect(&panel_, &LayerPanel::appeared, this, &LayerBounds::find);
  connect(&controller_, &RunController::started, this, [this] {
    if (!work_.busy()) return;
    work_.stop();
    run_.reset();
  });
}

void LayerBounds::find() {
  const std::shared_ptr<const FinishedRun> run = controller_.finishedRun();
  if (run == run_ || !run || !panel_.isVisible()) return;
  run_ = run;
  work_.stop();
  if (run->result.mesh->layerCount == 0) return;
  const auto look = [run](RunContext&) {
    return onThreads(0, [&](int) {
      const NavigationMesh& mesh = *run->result.mesh;
      return LayerCounts{mesh.connections.size(), leastLayers(mesh), leastConnections(mesh)};
    });
  };
  // Memory ran out: the list has no bounds.
  work_.start(
      *this, look, [this](const LayerCounts& counts) { panel_.setCounts(counts); }, [](const std::exception&) {});
}

}  // namespace footfall::ui
