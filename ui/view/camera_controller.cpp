// SPDX-License-Identifier: GPL-3.0-or-later
// LevelView's movements: steps of keys, wheel and trackpad, and the glide between two places of the camera.
#include <QGLViewer/manipulatedCameraFrame.h>

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "ui/view/level_view.hpp"

namespace footfall::ui {
namespace {

using qglviewer::Camera;
using qglviewer::Quaternion;
using qglviewer::Vec;

// Pivots are set on the camera's frame: Camera::setPivotPoint() would change the scale of parallel projections, which
// is the distance from the pivot here.

constexpr int kGlideMs = 180;
constexpr double kKeyShare = 0.08;        // of the distance to the pivot, with an arrow key
constexpr double kKeyDegrees = 7.5;       // with Ctrl or Shift and an arrow key
constexpr double kWheelFactor = 1.2;      // with a click of the wheel
constexpr double kDegreesPerPixel = 0.4;  // of two fingers on a trackpad
constexpr double kSteepest = 0.9995;      // sine of the angle to the ground, when turning

Quaternion orientationOf(const CameraPose& pose) {
  return {pose.orientation[0], pose.orientation[1], pose.orientation[2], pose.orientation[3]};
}

Vec mixed(const Vec& a, const Vec& b, double part) { return a + (b - a) * part; }

double radians(double degrees) { return degrees * M_PI / 180; }

}  // namespace

void LevelView::moved() {
  emit cameraMoved();
  update();
}

// --- Steps

void LevelView::zoomBy(double factor) {
  endGlide();
  const Vec pivot = camera()->pivotPoint();
  camera()->setPosition(pivot + (camera()->position() - pivot) / factor);
  moved();
}

void LevelView::zoomAt(double factor, const QPointF& place) {
  endGlide();
  // Towards what is seen there; where nothing is, towards the place at the pivot's distance.
  const Ray ray = sceneRayAt(place.toPoint());
  Vec target;
  const std::optional<SurfacePoint> seen = seenAlong(ray);
  if (seen) {
    target = Vec(seen->point.x, seen->point.y, seen->point.z);
  } else {
    const Vec origin(ray.origin.x, ray.origin.y, ray.origin.z);
    const Vec along(ray.direction.x, ray.direction.y, ray.direction.z);
    const Vec ahead = camera()->viewDirection();
    const double rate = along * ahead;
    const double depth = (camera()->pivotPoint() - origin) * ahead;
    target = rate != 0 ? origin + along * (depth / rate) : camera()->pivotPoint();
  }
  // Everything is scaled about the target; the pivot goes along, and with it the scale of parallel projections.
  camera()->frame()->setPivotPoint(target + (camera()->pivotPoint() - target) / factor);
  camera()->setPosition(target + (camera()->position() - target) / factor);
  moved();
}

void LevelView::turnBy(double sideways, double up) {
  endGlide();
  const Vec ahead = camera()->viewDirection();
  const double pitch = std::asin(std::clamp(-ahead.z, -1.0, 1.0));
  const double steepest = std::asin(kSteepest);
  const double next = std::clamp(pitch + radians(up), std::min(-steepest, pitch), std::max(steepest, pitch));
  const Quaternion turn =
      Quaternion(Vec(0, 0, 1), radians(sideways)) * Quaternion(camera()->rightVector(), pitch - next);
  const Vec pivot = camera()->pivotPoint();
  const Vec offset = turn.rotate(camera()->position() - pivot);
  camera()->setOrientation(turn * camera()->orientation());
  camera()->setPosition(pivot + offset);
  moved();
}

void LevelView::lookBy(double sideways, double up) {
  const Vec eye = camera()->position();
  const double reach = (camera()->pivotPoint() - eye).norm();
  turnBy(-sideways, -up);
  camera()->setPosition(eye);
  camera()->frame()->setPivotPoint(eye + camera()->viewDirection() * reach);
  moved();
}

void LevelView::panBy(const QPointF& pixels) {
  endGlide();
  const double depth = (camera()->pivotPoint() - camera()->position()) * camera()->viewDirection();
  const double unit = 2 * std::tan(camera()->fieldOfView() / 2) * std::max(depth, 1e-6 * sceneRadius()) / height();
  const Vec move = camera()->rightVector() * (-pixels.x() * unit) + camera()->upVector() * (pixels.y() * unit);
  camera()->setPosition(camera()->position() + move);
  camera()->frame()->setPivotPoint(camera()->pivotPoint() + move);
  moved();
}

void LevelView::walkBy(double right, double up, double ahead) {
  endGlide();
  const Vec move = camera()->rightVector() * right + Vec(0, 0, 1) * up + camera()->viewDirection() * ahead;
  camera()->setPosition(camera()->position() + move);
  camera()->frame()->setPivotPoint(camera()->pivotPoint() + move);
  moved();
}

bool LevelView::moveByKey(const QKeyEvent& event) {
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
    turnBy(x * kKeyDegrees, y * kKeyDegrees);
    return true;
  }
  endGlide();
  const double step = kKeyShare * (camera()->position() - camera()->pivotPoint()).norm();
  const Vec move = camera()->rightVector() * (x * step) + camera()->upVector() * (y * step);
  camera()->setPosition(camera()->position() + move);
  camera()->frame()->setPivotPoint(camera()->pivotPoint() + move);
  moved();
  return true;
}

// --- Wheel and trackpad

void LevelView::wheelEvent(QWheelEvent* event) {
  event->accept();
  const bool fingers = event->device() && event->device()->type() == QInputDevice::DeviceType::TouchPad;
  const QPointF pixels = event->pixelDelta().isNull() ? QPointF(event->angleDelta()) / 8 : QPointF(event->pixelDelta());
  if (fingers && !(event->modifiers() & Qt::ControlModifier)) {
    if (event->modifiers() & Qt::ShiftModifier) {
      panBy(pixels);
    } else {
      turnBy(-pixels.x() * kDegreesPerPixel, pixels.y() * kDegreesPerPixel);
    }
    return;
  }
  // With Alt, some systems turn the wheel by ninety degrees.
  const int delta = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  if (delta != 0) zoomAt(std::pow(kWheelFactor, delta / 120.0), event->position());
}

void LevelView::pinch(const QNativeGestureEvent& event) {
  if (event.gestureType() == Qt::ZoomNativeGesture) zoomAt(std::clamp(1 + event.value(), 0.2, 5.0), event.position());
  if (event.gestureType() == Qt::RotateNativeGesture) turnBy(event.value(), 0);
}

bool LevelView::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    pinch(*static_cast<QNativeGestureEvent*>(event));
    return true;
  }
  return QGLViewer::event(event);
}

// --- Projection and poses

bool LevelView::orthographic() const { return camera()->type() == Camera::ORTHOGRAPHIC; }

void LevelView::setOrthographic(bool on) {
  endGlide();
  // What is at the pivot keeps its size: libQGLViewer takes the scale from there.
  camera()->setType(on ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  moved();
  rest_.stop();
}

CameraPose LevelView::cameraPose() const { return glide_ ? glide_->to : poseNow(); }

CameraPose LevelView::poseNow() const {
  CameraPose pose;
  const Vec3 origin = environment_ ? environment_->centre : Vec3{};
  const Vec position = camera()->position();
  const Vec pivot = camera()->pivotPoint();
  pose.position = {position.x + origin.x, position.y + origin.y, position.z + origin.z};
  pose.pivot = {pivot.x + origin.x, pivot.y + origin.y, pivot.z + origin.z};
  const Quaternion orientation = camera()->orientation();
  for (int i = 0; i < 4; ++i) pose.orientation[static_cast<std::size_t>(i)] = orientation[i];
  pose.orthographic = camera()->type() == Camera::ORTHOGRAPHIC;
  return pose;
}

void LevelView::place(const CameraPose& pose) {
  const Vec3 origin = environment_ ? environment_->centre : Vec3{};
  camera()->setType(Camera::PERSPECTIVE);  // parallel projections then take their scale anew
  camera()->frame()->setPivotPoint(Vec(pose.pivot.x - origin.x, pose.pivot.y - origin.y, pose.pivot.z - origin.z));
  camera()->setOrientation(orientationOf(pose));
  camera()->setPosition(Vec(pose.position.x - origin.x, pose.position.y - origin.y, pose.position.z - origin.z));
  if (pose.orthographic) camera()->setType(Camera::ORTHOGRAPHIC);
}

void LevelView::setCameraPose(const CameraPose& pose) {
  endGlide();
  place(pose);
  fitWhenSized_ = false;
  update();
}

// --- Gliding

void LevelView::glideTo(const CameraPose& pose) {
  endGlide();
  const CameraPose from = poseNow();
  place(pose);
  glideFrom(from);
}

void LevelView::glideFrom(const CameraPose& from) {
  if (animated_ && isVisible()) {
    glide_ = Glide{from, poseNow(), {}};
    glide_->since.start();
    glideTimer_.start(15);
    place(from);
    return;
  }
  moved();
  rest_.stop();  // one jump is no movement
}

void LevelView::glide() {
  if (!glide_) return;
  const double time = static_cast<double>(glide_->since.elapsed()) / kGlideMs;
  if (time >= 1) {
    endGlide();
    return;
  }
  const double part = time * time * (3 - 2 * time);
  const auto vec = [](const Vec3& p) { return Vec(p.x, p.y, p.z); };
  const Quaternion first = orientationOf(glide_->from);
  const Quaternion last = orientationOf(glide_->to);
  // The way of the pivot, of the turn about it, and of where the eye is as seen from it.
  const Vec pivot = mixed(vec(glide_->from.pivot), vec(glide_->to.pivot), part);
  const Vec eye = mixed(first.inverseRotate(vec(glide_->from.position) - vec(glide_->from.pivot)),
                        last.inverseRotate(vec(glide_->to.position) - vec(glide_->to.pivot)), part);
  const Quaternion turn = Quaternion::slerp(first, last, part);
  const Vec position = pivot + turn.rotate(eye);
  CameraPose pose;
  pose.pivot = {pivot.x, pivot.y, pivot.z};
  pose.position = {position.x, position.y, position.z};
  for (int i = 0; i < 4; ++i) pose.orientation[static_cast<std::size_t>(i)] = turn[i];
  pose.orthographic = glide_->from.orthographic && glide_->to.orthographic;
  place(pose);
  moved();
}

void LevelView::endGlide() {
  if (!glide_) return;
  glideTimer_.stop();
  const CameraPose to = glide_->to;
  glide_.reset();
  place(to);
  moved();
  rest_.stop();
}

}  // namespace footfall::ui
