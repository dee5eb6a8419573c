// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/camera_input.hpp"

#include <QInputDevice>
#include <algorithm>
#include <cmath>

namespace footfall::ui {
namespace {

constexpr double kKeyShare = 0.08;              // share of the distance to the pivot, for an arrow key
constexpr double kKeyDegrees = 7.5;             // with Ctrl or Shift and an arrow key
constexpr double kWheelFactor = 1.2;            // for a click of the wheel
constexpr double kFingerDegreesPerPixel = 0.4;  // for two fingers on a trackpad

}  // namespace

bool steerByKey(CameraController& camera, const QKeyEvent& event) {
  double x = 0;
  double y = 0;
  switch (event.key()) {
    case Qt::Key_Left:
      x = -1;
      break;
    case Qt::Key_Right:
      x = 1;
      break;
    case Qt::Key_Up:
      y = 1;
      break;
    case Qt::Key_Down:
      y = -1;
      break;
    default:
      return false;
  }
  if (event.modifiers() & (Qt::ControlModifier | Qt::ShiftModifier)) {
    camera.turnBy(x * kKeyDegrees, y * kKeyDegrees);
  } else {
    camera.shiftBy(x * kKeyShare, y * kKeyShare);
  }
  return true;
}

void steerByWheel(CameraController& camera, const QWheelEvent& event) {
  const bool fingers = event.device() && event.device()->type() == QInputDevice::DeviceType::TouchPad;
  const QPointF pixels = event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 8 : QPointF(event.pixelDelta());
  if (fingers && !(event.modifiers() & Qt::ControlModifier)) {
    if (event.modifiers() & Qt::ShiftModifier) {
      camera.panBy(pixels);
    } else {
      camera.turnBy(-pixels.x() * kFingerDegreesPerPixel, pixels.y() * kFingerDegreesPerPixel);
    }
    return;
  }
  // Some systems turn the wheel's axis by ninety degrees while Alt is held.
  const int delta = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
  if (delta != 0) camera.zoomAt(std::pow(kWheelFactor, delta / 120.0), event.position());
}

void steerByPinch(CameraController& camera, const QNativeGestureEvent& event) {
  if (event.gestureType() == Qt::ZoomNativeGesture)
    camera.zoomAt(std::clamp(1 + event.value(), 0.2, 5.0), event.position());
  if (event.gestureType() == Qt::RotateNativeGesture) camera.turnBy(event.value(), 0);
}

}  // namespace footfall::ui
