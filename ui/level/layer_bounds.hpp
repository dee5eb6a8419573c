// Finds how many layers and connections a result needs at least, for the list of layers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "ui/base/work/latest_work.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/widgets/layer_panel.hpp"

namespace footfall::ui {

/// Works in the background on one thread after a run, while the list is in sight. It begins when no run has followed
/// for a moment; the bounds of a result that is no longer the last are dropped.
class LayerBounds : public QObject {
  Q_OBJECT

 public:
  LayerBounds(RunController& controller, LayerPanel& panel);

 private:
  void find();

  RunController& controller_;
  LayerPanel& panel_;
  QTimer rest_;
  std::weak_ptr<const FinishedRun> run_;  ///< its bounds are known or sought
  LatestWork work_;                       // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
