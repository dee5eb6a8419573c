// The editor's tools, each in files of its own: one line a tool.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/camera_tools.hpp"
#include "ui/editor_window.hpp"
#include "ui/level_look.hpp"

namespace footfall {

void EditorWindow::createFeatures() {
  installLevelLook(*this);
  installCameraTools(*this);
}

}  // namespace footfall
