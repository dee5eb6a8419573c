// Moves the camera by keys, wheel and trackpad.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>

#include "ui/view/camera/camera_controller.hpp"

namespace footfall::ui {

/// Handles the arrow keys, which move, or turn with Ctrl or Shift; returns false for other keys.
bool steerByKey(CameraController& camera, const QKeyEvent& event);
/// A wheel zooms at the mouse. Two fingers on a trackpad turn, with Shift they move, with Ctrl they zoom.
void steerByWheel(CameraController& camera, const QWheelEvent& event);
void steerByPinch(CameraController& camera, const QNativeGestureEvent& event);

}  // namespace footfall::ui
