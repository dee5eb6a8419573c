// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera_controller.hpp"

#include <QGLViewer/manipulatedCameraFrame.h>

#include <QCursor>
#include <QInputDevice>
#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/camera_fit.hpp"

namespace footfall::ui {
namespace {

using qglviewer::Camera;
using qglviewer::Quaternion;
using qglviewer::Vec;

// Pivots are set on the camera's frame: Camera::setPivotPoint() would change the scale of parallel projections, which
// is the distance from the pivot here.

constexpr int kGlideMs = 180;
constexpr double kLeastFrame = 0.01;      // of the scene's radius: nearer, there is nothing but one surface
constexpr double kKeyShare = 0.08;        // of the distance to the pivot, with an arrow key
constexpr double kKeyDegrees = 7.5;       // with Ctrl or Shift and an arrow key
constexpr double kWheelFactor = 1.2;      // with a click of the wheel
constexpr double kDegreesPerPixel = 0.4;  // of two fingers on a trackpad
constexpr double kSteepest = 0.9995;      // sine of the angle to the ground, when turning

double radians(double degrees) { return degrees * M_PI / 180; }

}  // namespace

CameraController::CameraController(QGLViewer& viewer, Seen seen) : viewer_(viewer), seen_(std::move(seen)) {
  connect(&glideTimer_, &QTimer::timeout, this, &CameraController::glide);
}

Vec3 CameraController::origin() const { return scene_ ? scene_->centre : Vec3{}; }

void CameraController::setScene(std::shared_ptr<const EnvironmentGeometry> scene, bool fit) {
  scene_ = std::move(scene);
  if (scene_) {
    const double radius = toVec(scene_->upper).norm();
    viewer_.setSceneCenter(Vec(0, 0, 0));
    viewer_.setSceneRadius(radius > 0 ? radius : 1);
  }
  if (!fit) return;
  viewOblique();
  fitWhenSized_ = !viewer_.isVisible();
  opened_ = pose();
}

void CameraController::replaceScene(std::shared_ptr<const EnvironmentGeometry> scene) {
  scene_ = std::move(scene);
  if (!scene_) return;
  // What has grown must not be cut off behind.
  viewer_.setSceneRadius(std::max({viewer_.sceneRadius(), toVec(scene_->lower).norm(), toVec(scene_->upper).norm()}));
}

// --- Poses and glides

CameraPose CameraController::pose() const { return glide_ ? glide_->to : poseNow(); }

void CameraController::place(const CameraPose& pose) { ui::setPose(camera(), pose, origin()); }

void CameraController::setPose(const CameraPose& pose) {
  endGlide();
  place(pose);
  fitWhenSized_ = false;
  viewer_.update();
}

void CameraController::step() {
  emit moved();
  viewer_.update();
}

void CameraController::jump() {
  step();
  emit arrived();
}

void CameraController::glideTo(const CameraPose& pose) {
  endGlide();
  const CameraPose from = poseNow();
  place(pose);
  glideFrom(from);
}

// The camera has been placed where it goes.
void CameraController::glideFrom(const CameraPose& from) {
  if (!animated_ || forPicture_ || !viewer_.isVisible()) return jump();
  glide_ = Glide{from, poseNow(), {}};
  glide_->since.start();
  glideTimer_.start(15);
  place(from);
}

void CameraController::glide() {
  if (!glide_) return;
  const double time = static_cast<double>(glide_->since.elapsed()) / kGlideMs;
  if (time >= 1) return endGlide();
  place(between(glide_->from, glide_->to, time * time * (3 - 2 * time)));
  step();
}

void CameraController::endGlide() {
  if (!glide_) return;
  glideTimer_.stop();
  const CameraPose to = glide_->to;
  glide_.reset();
  place(to);
  jump();
}

// --- Steps

void CameraController::zoomBy(double factor) {
  endGlide();
  const Vec pivot = camera().pivotPoint();
  camera().setPosition(pivot + (camera().position() - pivot) / factor);
  step();
}

void CameraController::zoomAt(double factor, const QPointF& place) {
  endGlide();
  // Towards what is seen there; where nothing is, towards the place at the pivot's distance.
  const Ray ray = sightAt(camera(), place.toPoint());
  Vec target;
  if (const std::optional<Vec3> seen = seen_(ray)) {
    target = toVec(*seen);
  } else {
    const Vec from = toVec(ray.origin);
    const Vec along = toVec(ray.direction);
    const Vec ahead = camera().viewDirection();
    const double rate = along * ahead;
    const double depth = (camera().pivotPoint() - from) * ahead;
    target = rate != 0 ? from + along * (depth / rate) : camera().pivotPoint();
  }
  // Everything is scaled about the target; the pivot goes along, and with it the scale of parallel projections.
  camera().frame()->setPivotPoint(target + (camera().pivotPoint() - target) / factor);
  camera().setPosition(target + (camera().position() - target) / factor);
  step();
}

void CameraController::turnBy(double sideways, double up) {
  endGlide();
  const Vec ahead = camera().viewDirection();
  const double pitch = std::asin(std::clamp(-ahead.z, -1.0, 1.0));
  const double steepest = std::asin(kSteepest);
  const double next = std::clamp(pitch + radians(up), std::min(-steepest, pitch), std::max(steepest, pitch));
  const Quaternion turn =
      Quaternion(Vec(0, 0, 1), radians(sideways)) * Quaternion(camera().rightVector(), pitch - next);
  const Vec pivot = camera().pivotPoint();
  const Vec offset = turn.rotate(camera().position() - pivot);
  camera().setOrientation(turn * camera().orientation());
  camera().setPosition(pivot + offset);
  step();
}

void CameraController::lookBy(double sideways, double up) {
  const Vec eye = camera().position();
  const double reach = (camera().pivotPoint() - eye).norm();
  turnBy(-sideways, -up);
  camera().setPosition(eye);
  camera().frame()->setPivotPoint(eye + camera().viewDirection() * reach);
  step();
}

// With the pivot.
void CameraController::shift(const Vec& way) {
  camera().setPosition(camera().position() + way);
  camera().frame()->setPivotPoint(camera().pivotPoint() + way);
  step();
}

void CameraController::panBy(const QPointF& pixels) {
  endGlide();
  const double depth = (camera().pivotPoint() - camera().position()) * camera().viewDirection();
  const double unit =
      2 * std::tan(camera().fieldOfView() / 2) * std::max(depth, 1e-6 * viewer_.sceneRadius()) / viewer_.height();
  shift(camera().rightVector() * (-pixels.x() * unit) + camera().upVector() * (pixels.y() * unit));
}

void CameraController::walkBy(double right, double up, double ahead) {
  endGlide();
  shift(camera().rightVector() * right + Vec(0, 0, 1) * up + camera().viewDirection() * ahead);
}

// --- Keys, wheel and trackpad

bool CameraController::keyPressed(const QKeyEvent& event) {
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
  const double way = kKeyShare * (camera().position() - camera().pivotPoint()).norm();
  shift(camera().rightVector() * (x * way) + camera().upVector() * (y * way));
  return true;
}

void CameraController::wheel(const QWheelEvent& event) {
  const bool fingers = event.device() && event.device()->type() == QInputDevice::DeviceType::TouchPad;
  const QPointF pixels = event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 8 : QPointF(event.pixelDelta());
  if (fingers && !(event.modifiers() & Qt::ControlModifier)) {
    if (event.modifiers() & Qt::ShiftModifier) {
      panBy(pixels);
    } else {
      turnBy(-pixels.x() * kDegreesPerPixel, pixels.y() * kDegreesPerPixel);
    }
    return;
  }
  // With Alt, some systems turn the wheel by ninety degrees.
  const int delta = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
  if (delta != 0) zoomAt(std::pow(kWheelFactor, delta / 120.0), event.position());
}

void CameraController::pinch(const QNativeGestureEvent& event) {
  if (event.gestureType() == Qt::ZoomNativeGesture) zoomAt(std::clamp(1 + event.value(), 0.2, 5.0), event.position());
  if (event.gestureType() == Qt::RotateNativeGesture) turnBy(event.value(), 0);
}

// --- Views of the whole

bool CameraController::orthographic() const { return camera().type() == Camera::ORTHOGRAPHIC; }

void CameraController::setOrthographic(bool on) {
  endGlide();
  // What is at the pivot keeps its size: libQGLViewer takes the scale from there.
  camera().setType(on ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  jump();
}

// Jumps: the camera is placed at once, and then glides there.
void CameraController::lookAlong(const Vec& direction, const Vec& up, bool orthographic) {
  endGlide();
  const CameraPose from = poseNow();
  camera().setType(orthographic ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  const Vec d = direction.unit();
  const Vec right = (d ^ up).unit();
  const Vec upright = right ^ d;
  Quaternion orientation;
  orientation.setFromRotatedBasis(right, upright, -d);
  camera().setOrientation(orientation);
  if (scene_) standBefore(scene_->detailExtremes);
  glideFrom(from);
}

void CameraController::viewFrom(ViewSide side) {
  const Vec upright(0, 0, 1);
  switch (side) {
    case ViewSide::Top:
      return viewFromTop();
    case ViewSide::Bottom:
      return lookAlong(Vec(0, 0, 1), Vec(0, 1, 0), true);
    case ViewSide::Front:
      return lookAlong(Vec(0, 1, 0), upright, true);
    case ViewSide::Back:
      return lookAlong(Vec(0, -1, 0), upright, true);
    case ViewSide::Left:
      return lookAlong(Vec(1, 0, 0), upright, true);
    case ViewSide::Right:
      return lookAlong(Vec(-1, 0, 0), upright, true);
  }
}

void CameraController::viewFromTop() { lookAlong(Vec(0, 0, -1), Vec(0, 1, 0), true); }

void CameraController::viewOblique() { lookAlong(Vec(0.5, 0.8, -0.9), Vec(0, 0, 1), false); }

void CameraController::refit() {
  if (!scene_ || glide_ || !opened_ || !(poseNow() == *opened_)) return;
  standBefore(scene_->detailExtremes);
  opened_ = poseNow();
  jump();
}

void CameraController::fit() {
  if (scene_) fitTo(scene_->extremes);
}

void CameraController::standBefore(const std::vector<Vec3>& points) {
  fitCamera(camera(), points, viewer_.size(), forPicture_ ? std::vector<QRect>() : covered_);
}

// --- What to have in sight

void CameraController::fitTo(const std::vector<Vec3>& points) {
  endGlide();
  const CameraPose from = poseNow();
  standBefore(points);
  glideFrom(from);
}

void CameraController::frameInScene(const Vec& lower, const Vec& upper) {
  const Vec middle = (lower + upper) / 2;
  const double least = kLeastFrame * viewer_.sceneRadius();
  Vec half = (upper - lower) / 2;
  if (half.norm() < least) half = Vec(least, least, least) / std::sqrt(3.0);
  std::vector<Vec3> corners;
  for (const double x : {-half.x, half.x}) {
    for (const double y : {-half.y, half.y}) {
      for (const double z : {-half.z, half.z}) corners.push_back({middle.x + x, middle.y + y, middle.z + z});
    }
  }
  fitTo(corners);
}

void CameraController::frame(const Vec3& lower, const Vec3& upper) {
  frameInScene(toVec(lower - origin()), toVec(upper - origin()));
}

void CameraController::lookAt(const Vec3& place) {
  const Vec target = toVec(place - origin());
  endGlide();
  const CameraPose from = poseNow();
  const double distance = (camera().position() - camera().pivotPoint()).norm();
  camera().frame()->setPivotPoint(target);
  camera().setPosition(target - camera().viewDirection() * distance);
  glideFrom(from);
}

void CameraController::setSelectionBounds(const QString& owner, const std::optional<SceneBox>& bounds) {
  const auto known = std::ranges::find(selections_, owner, &std::pair<QString, SceneBox>::first);
  if (known != selections_.end()) {
    if (bounds && known->second == *bounds) return;
    selections_.erase(known);
  }
  if (bounds) selections_.emplace_back(owner, *bounds);
}

void CameraController::frameSelection() {
  if (!selections_.empty()) {
    const SceneBox box = selections_.back().second;
    return frame(box.lower, box.upper);
  }
  const std::optional<Vec> pointed = pointedAt(viewer_.rect());
  if (!pointed) return fit();
  // Twice as near, at least.
  const Vec place = *pointed;
  const double reach = (place - camera().position()).norm() * std::tan(camera().fieldOfView() / 2);
  const double half = reach / 2 / std::sqrt(3.0);
  const Vec around(half, half, half);
  frameInScene(place - around, place + around);
}

std::optional<Vec> CameraController::pointedAt(const QRect& view) const {
  const QPoint mouse = viewer_.mapFromGlobal(QCursor::pos()) - view.topLeft();
  if (!QRect({0, 0}, view.size()).contains(mouse)) return std::nullopt;
  camera().setScreenWidthAndHeight(view.width(), view.height());
  const Ray ray = sightAt(camera(), mouse);
  camera().setScreenWidthAndHeight(viewer_.width(), viewer_.height());
  const std::optional<Vec3> seen = seen_(ray);
  return seen ? std::optional(toVec(*seen)) : std::nullopt;
}

// --- The size of the view

void CameraController::resized() {
  if (forPicture_) return;
  const Placed now{QRect(viewer_.mapTo(viewer_.window(), QPoint(0, 0)), viewer_.size()), viewer_.window()->size()};
  const std::optional<Placed> before = std::exchange(placed_, now);
  if (fitWhenSized_ && scene_) {
    standBefore(scene_->detailExtremes);
    opened_ = poseNow();
    jump();
  } else if (before && viewer_.isVisible() && before->window == now.window && before->inWindow != now.inWindow) {
    keepPicture(*before, now);
  }
  fitWhenSized_ = false;
}

// A dock has come or gone: what was at a place of the screen stays there, as large as it was, at the depth of what the
// mouse points at (else the pivot's). Perspective moves what is nearer or farther.
void CameraController::keepPicture(const Placed& before, const Placed& now) {
  endGlide();
  if (before.inWindow.height() <= 0 || now.inWindow.height() <= 0) return;
  const Vec ahead = camera().viewDirection();
  // In a parallel projection, libQGLViewer takes the scale from the pivot's depth and from the shorter side.
  const std::optional<Vec> pointed =
      orthographic() ? std::nullopt : pointedAt(before.inWindow.translated(-now.inWindow.topLeft()));
  const Vec kept = pointed.value_or(camera().pivotPoint());
  const double depth = (kept - camera().position()) * ahead;
  if (!(depth > 0)) return;
  const auto extent = [this](const QRect& rect) {
    return orthographic() ? std::min(rect.width(), rect.height()) : rect.height();
  };
  const double scaled = depth * extent(now.inWindow) / extent(before.inWindow);
  const double unit = 2 * std::tan(camera().fieldOfView() / 2) * scaled / extent(now.inWindow);
  const QPointF way = QRectF(now.inWindow).center() - QRectF(before.inWindow).center();
  const Vec move = camera().rightVector() * (way.x() * unit) - camera().upVector() * (way.y() * unit);
  camera().setPosition(camera().position() - ahead * (scaled - depth) + move);
  viewer_.update();
}

}  // namespace footfall::ui
