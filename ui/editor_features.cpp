// The editor's tools, each in files of its own: one line a tool.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor_window.hpp"
#include "ui/environment_tools.hpp"
#include "ui/obstacle_features.hpp"

namespace footfall {

void EditorWindow::createFeatures() {
  new EnvironmentTools(*this);  // a child of the window
  new ObstacleFeatures(*this);
}

}  // namespace footfall
