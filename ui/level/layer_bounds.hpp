// Finds how many layers and connections a result needs at least, for the list of layers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "ui/base/work/latest_work.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/widgets/layer_panel.hpp"

namespace footfall::ui {

/// Works in the background after a run, while the list is in sight. A run that begins stops it, because it needs the
/// processors.
class LayerBounds : public QObject {
  Q_OBJECT

 public:
  LayerBounds(RunController& controller, LayerPanel& panel);

 private:
  void find();

  RunController& controller_;
  LayerPanel& panel_;
  std::shared_ptr<const FinishedRun> run_;  ///< whose bounds are known or sought
  LatestWork work_;                         // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
