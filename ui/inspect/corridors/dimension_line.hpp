// A passage in the view: its width as a line from border to border.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

#include "footfall/body_path.hpp"
#include "ui/view/camera/camera_pose.hpp"
#include "ui/view/overlays/view_overlay.hpp"

namespace footfall::ui {

/// Adds the line, a mark on each border, and the text at the passage's place.
void addDimension(ViewOverlay& overlay, const Passage& passage, const QColor& colour, const QString& text);

/// The passage with `margin` around it in the plan, for the camera.
SceneBox boxAround(const Passage& passage, double margin);

}  // namespace footfall::ui
