// What keys, wheel and trackpad do to the camera.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>

#include "ui/view/camera_controller.hpp"

namespace footfall::ui {

/// The arrow keys: move, or turn with Ctrl or Shift; false for other keys.
bool steerByKey(CameraController& camera, const QKeyEvent& event);
/// A wheel zooms about the mouse. Two fingers on a trackpad turn, with Shift they move, with Ctrl they zoom.
void steerByWheel(CameraController& camera, const QWheelEvent& event);
void steerByPinch(CameraController& camera, const QNativeGestureEvent& event);

}  // namespace footfall::ui
