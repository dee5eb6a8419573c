// The editor's tools, each in files of its own: one line a tool. All are children of the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/camera_tools.hpp"
#include "ui/compare_feature.hpp"
#include "ui/editor_window.hpp"
#include "ui/environment_tools.hpp"
#include "ui/filter_tools.hpp"
#include "ui/inspection_feature.hpp"
#include "ui/level_look.hpp"
#include "ui/measure_panel.hpp"
#include "ui/obstacle_features.hpp"
#include "ui/path_feature.hpp"
#include "ui/skipped_feature.hpp"
#include "ui/unit_tools.hpp"

namespace footfall {

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

}  // namespace footfall
