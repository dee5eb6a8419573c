// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/camera_controller.hpp"

#include <QGLViewer/manipulatedCameraFrame.h>

#include <QCursor>
#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/camera/camera_fit.hpp"

namespace footfall::ui {
namespace {

using qglviewer::Camera;
using qglviewer::Quaternion;
using qglviewer::Vec;

// Pivots are set on the camera's frame, because Camera::setPivotPoint() would change the scale of parallel projections,
// which is the distance from the pivot here.

constexpr double kLeastFrame = 0.01;  // share of the scene's radius: nearer, only one surface is visible
constexpr double kSteepest = 0.9995;  // sine of the largest angle to the ground when turning
constexpr double kStill = 1e-9;       // share of the coordinates: a camera that moved less has only been rounded

double radians(double degrees) { return degrees * M_PI / 180; }

bool isFinite(const Vec& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isNear(const Vec3& a, const Vec3& b, double most) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) <= most; }

bool isAlike(const CameraPose& a, const CameraPose& b, double most) {
  return isNear(a.position, b.position, most) && isNear(a.pivot, b.pivot, most) && a.orthographic == b.orthographic &&
         std::ranges::equal(a.orientation, b.orientation, [](double p, double q) { return std::abs(p - q) <= kStill; });
}

}  // namespace

CameraController::CameraController(QGLViewer& viewer, Seen seen)
    : viewer_(viewer), seen_(std::move(seen)), glide_(viewer) {
  connect(&glide_, &CameraGlide::moved, this, &CameraController::step);
  connect(&glide_, &CameraGlide::arrived, this, &CameraController::arrived);
}

Vec3 CameraController::origin() const { return scene_ ? scene_->centre : Vec3{}; }

void CameraController::setScene(std::shared_ptr<const EnvironmentGeometry> scene, bool fit) {
  scene_ = std::move(scene);
  glide_.setOrigin(origin());
  if (scene_) {
    const double radius = toVec(scene_->upper).norm();
    viewer_.setSceneCenter(Vec(0, 0, 0));
    viewer_.setSceneRadius(radius > 0 ? radius : 1);
  }
  if (!fit) return;
  viewOblique();
  framed_ = pose();
}

void CameraController::replaceScene(std::shared_ptr<const EnvironmentGeometry> scene) {
  scene_ = std::move(scene);
  glide_.setOrigin(origin());
  if (!scene_) return;
  // A larger scene must not be cut off behind.
  viewer_.setSceneRadius(std::max({viewer_.sceneRadius(), toVec(scene_->lower).norm(), toVec(scene_->upper).norm()}));
}

// --- Poses

// A camera whose place is no number would show nothing.
void CameraController::setPose(const CameraPose& pose) {
  if (!isFinite(toVec(pose.position)) || !isFinite(toVec(pose.pivot))) return;
  endGlide();
  glide_.place(pose);
  framed_.reset();
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
  const CameraPose from = glide_.now();
  glide_.place(pose);
  glide_.glideFrom(from);
}

void CameraController::setForPicture(bool on) {
  forPicture_ = on;
  glide_.setStill(on);
}

// --- Steps

void CameraController::zoomBy(double factor) {
  endGlide();
  const Vec pivot = camera().pivotPoint();
  const Vec position = pivot + (camera().position() - pivot) / factor;
  if (!isFinite(position)) return;
  camera().setPosition(position);
  step();
}

void CameraController::zoomAt(double factor, const QPointF& place) {
  endGlide();
  // Zooms towards the surface under the mouse; without a surface, towards the place at the pivot's distance.
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
  // The view is scaled about the target; the pivot moves with it, and so does the scale of parallel projections.
  const Vec pivot = target + (camera().pivotPoint() - target) / factor;
  const Vec position = target + (camera().position() - target) / factor;
  if (!isFinite(pivot) || !isFinite(position)) return;
  camera().frame()->setPivotPoint(pivot);
  camera().setPosition(position);
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

// The picture stays. The scale of a parallel projection is the distance from the pivot, so the eye moves along the
// view.
void CameraController::turnAbout(const QPoint& place) {
  endGlide();
  const std::optional<Vec3> seen = seen_(sightAt(camera(), place));
  if (!seen || !isFinite(toVec(*seen))) return;
  const Vec pivot = toVec(*seen);
  const Vec ahead = camera().viewDirection();
  if (orthographic()) camera().setPosition(camera().position() + ahead * ((pivot - camera().pivotPoint()) * ahead));
  camera().frame()->setPivotPoint(pivot);
  step();
}

// Moves the camera together with the pivot.
void CameraController::shift(const Vec& way) {
  if (!isFinite(way)) return;
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

void CameraController::shiftBy(double right, double up) {
  endGlide();
  const double way = (camera().position() - camera().pivotPoint()).norm();
  shift(camera().rightVector() * (right * way) + camera().upVector() * (up * way));
}

void CameraController::walkBy(double right, double up, double ahead) {
  endGlide();
  shift(camera().rightVector() * right + Vec(0, 0, 1) * up + camera().viewDirection() * ahead);
}

// --- Views of the whole

bool CameraController::orthographic() const { return camera().type() == Camera::ORTHOGRAPHIC; }

void CameraController::setOrthographic(bool on) {
  endGlide();
  // Objects at the pivot keep their size, because libQGLViewer derives the scale from there.
  camera().setType(on ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  jump();
}

// The camera is placed at once, and then glides there.
void CameraController::lookAlong(const Vec& direction, const Vec& up, bool orthographic) {
  endGlide();
  const CameraPose from = glide_.now();
  camera().setType(orthographic ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  const Vec d = direction.unit();
  const Vec right = (d ^ up).unit();
  const Vec upright = right ^ d;
  Quaternion orientation;
  orientation.setFromRotatedBasis(right, upright, -d);
  camera().setOrientation(orientation);
  if (scene_) standBefore(scene_->detailExtremes);
  glide_.glideFrom(from);
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

// A camera that still glides to where opening has sent it glides on to the new place.
bool CameraController::frameAgain() {
  if (!framed_ || !scene_ || forPicture_) return false;
  const double reach = viewer_.sceneRadius() + std::hypot(origin().x, origin().y, origin().z);
  if (!isAlike(glide_.target(), *framed_, kStill * reach)) {
    framed_.reset();
    return false;
  }
  const CameraPose from = glide_.now();
  const bool glides = glide_.isGliding();
  glide_.place(*framed_);
  standBefore(scene_->detailExtremes);
  framed_ = glide_.now();
  if (glides)
    glide_.glideFrom(from);
  else
    jump();
  return true;
}

void CameraController::endFraming() {
  frameAgain();
  framed_.reset();
}

void CameraController::setCovered(std::vector<QRect> rects) {
  if (rects == covered_) return;
  covered_ = std::move(rects);
  frameAgain();
}

void CameraController::fit() {
  if (scene_) fitTo(scene_->extremes);
}

void CameraController::standBefore(const std::vector<Vec3>& points) {
  // The view may have a size of which OpenGL does not know yet.
  camera().setScreenWidthAndHeight(viewer_.width(), viewer_.height());
  fitCamera(camera(), points, viewer_.size(), forPicture_ ? std::vector<QRect>() : covered_);
}

// --- Bringing things into view

void CameraController::fitTo(const std::vector<Vec3>& points) {
  endGlide();
  const CameraPose from = glide_.now();
  standBefore(points);
  glide_.glideFrom(from);
}

void CameraController::frameInScene(const Vec& lower, const Vec& upper) {
  if (!isFinite(lower) || !isFinite(upper)) return;  // the bounds of nothing
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
  if (!isFinite(target)) return;
  endGlide();
  const CameraPose from = glide_.now();
  const double distance = (camera().position() - camera().pivotPoint()).norm();
  camera().frame()->setPivotPoint(target);
  camera().setPosition(target - camera().viewDirection() * distance);
  glide_.glideFrom(from);
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
  // The distance is at least halved.
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
  if (frameAgain()) return;
  if (before && viewer_.isVisible() && before->window == now.window && before->inWindow != now.inWindow) {
    keepPicture(*before, now);
  }
}

// A dock was shown or hidden. Every place of the screen keeps its content and scale, at the depth of the surface under
// the mouse (else the pivot's); perspective moves nearer and farther surfaces.
void CameraController::keepPicture(const Placed& before, const Placed& now) {
  endGlide();
  if (before.inWindow.height() <= 0 || now.inWindow.height() <= 0) return;
  const Vec ahead = camera().viewDirection();
  // libQGLViewer derives the scale of a parallel projection from the pivot's depth and from the shorter side.
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
