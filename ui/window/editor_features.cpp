// The editor's tools, each in files of its own: one line a tool. All are children of the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_tools.hpp"
#include "ui/inspect/compare_feature.hpp"
#include "ui/inspect/inspection_feature.hpp"
#include "ui/inspect/measure_panel.hpp"
#include "ui/level/environment_tools.hpp"
#include "ui/level/obstacle_features.hpp"
#include "ui/level/skipped_feature.hpp"
#include "ui/level/unit_tools.hpp"
#include "ui/path/path_feature.hpp"
#include "ui/view/camera_tools.hpp"
#include "ui/view/level_look.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

void EditorWindow::createFeatures() {
  addFilterTools(*this);
  installUnitTools(*this);
  new EnvironmentTools(*this);
  installLevelLook(*this);
  connect(&findChild<LevelLook*>()->modes(), &ViewModes::ready, this, &EditorWindow::writePendingExports,
          Qt::QueuedConnection);
  installCameraTools(*this);
  new PathFeature(*this);
  new MeasureFeature(*this);
  new InspectionFeature(*this);
  new ObstacleFeatures(*this);
  new SkippedFeature(*this);
  new CompareFeature(*this);
}

}  // namespace footfall::ui
