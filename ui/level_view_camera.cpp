// SPDX-License-Identifier: GPL-3.0-or-later
// LevelView's camera: how mouse and keys move it, and where it looks from.
#include <QGLViewer/manipulatedCameraFrame.h>

#include <QCursor>
#include <QKeyEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "ui/level_view.hpp"

namespace footfall {
namespace {

using qglviewer::Camera;
using qglviewer::Quaternion;
using qglviewer::Vec;

constexpr double kMargin = 1.08;      // around the scene when everything is to be in sight
constexpr double kLeastFrame = 0.01;  // of the scene's radius: nearer, there is nothing but one surface

Vec toVec(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

void LevelView::bindMouse() {
  clearMouseBindings();
  clearShortcuts();
  for (int key = Qt::Key_F1; key <= Qt::Key_F12; ++key) setPathKey(-key);  // no camera paths on function keys
  setMouseBinding(Qt::NoModifier, Qt::LeftButton, CAMERA, ROTATE);
  setMouseBinding(Qt::NoModifier, Qt::RightButton, CAMERA, TRANSLATE);
  setMouseBinding(Qt::NoModifier, Qt::MiddleButton, CAMERA, TRANSLATE);
  setMouseBinding(Qt::ShiftModifier, Qt::LeftButton, CAMERA, TRANSLATE);
  setMouseBinding(Qt::ControlModifier, Qt::LeftButton, CAMERA, ZOOM);
  setMouseBinding(Qt::NoModifier, Qt::LeftButton, RAP_FROM_PIXEL, true);
  camera()->frame()->setZoomSensitivity(1.0);
  camera()->frame()->setSpinningSensitivity(1e9);  // the camera stops with the mouse
}

void LevelView::frameCell(std::size_t cell) {
  if (!cells_ || cell >= cells_->boxes.size()) return;
  const CellBox& box = cells_->boxes[cell];
  // Between the floors of the cell rather than between the sky and the cellar.
  float lowest = std::numeric_limits<float>::max();
  float highest = std::numeric_limits<float>::lowest();
  for (std::size_t v = cells_->firstVertex[cell]; v < cells_->firstVertex[cell + 1]; ++v) {
    lowest = std::min(lowest, cells_->surface[v].position[2]);
    highest = std::max(highest, cells_->surface[v].position[2]);
  }
  if (lowest > highest) lowest = highest = box.lower[2];
  std::vector<Vec3> corners;
  for (const float x : {box.lower[0], box.upper[0]}) {
    for (const float y : {box.lower[1], box.upper[1]}) {
      for (const float z : {lowest, highest}) corners.push_back({x, y, z});
    }
  }
  fitTo(corners);
}

// Jumps: the camera is placed at once, and then glides there.
void LevelView::fitTo(const std::vector<Vec3>& points) {
  endGlide();
  const CameraPose from = poseNow();
  standBefore(points);
  glideFrom(from);
}

void LevelView::lookAlong(const Vec& direction, const Vec& up, bool orthographic) {
  endGlide();
  const CameraPose from = poseNow();
  camera()->setType(orthographic ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  const Vec d = direction.unit();
  const Vec right = (d ^ up).unit();
  const Vec upright = right ^ d;
  Quaternion orientation;
  orientation.setFromRotatedBasis(right, upright, -d);
  camera()->setOrientation(orientation);
  if (environment_) standBefore(environment_->detailExtremes);
  glideFrom(from);
}

void LevelView::viewFrom(ViewSide side) {
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

void LevelView::viewFromTop() { lookAlong(Vec(0, 0, -1), Vec(0, 1, 0), true); }

void LevelView::viewOblique() { lookAlong(Vec(0.5, 0.8, -0.9), Vec(0, 0, 1), false); }

void LevelView::fit() {
  if (environment_) fitTo(environment_->extremes);
}

void LevelView::standBefore(const std::vector<Vec3>& points) {
  if (points.empty()) return;
  const Vec right = camera()->rightVector();
  const Vec up = camera()->upVector();
  const Vec ahead = camera()->viewDirection();
  const bool parallel = camera()->type() == Camera::ORTHOGRAPHIC;
  const double tanVertical = std::tan(camera()->fieldOfView() / 2) / kMargin;
  const double tanHorizontal = tanVertical * std::max(0.1, width() / std::max(1.0, static_cast<double>(height())));

  // Each side of the view's pyramid (or prism) touches the scene's outermost point: along each of the two axes, p is in
  // sight of the eye e when |p - e| <= tan * (depth of p - depth of e).
  constexpr double kLowest = std::numeric_limits<double>::lowest();
  std::array<double, 2> above{kLowest, kLowest};
  std::array<double, 2> below{kLowest, kLowest};
  double nearest = -kLowest;
  double farthest = kLowest;
  for (const Vec3& point : points) {
    const Vec p = toVec(point);
    const double depth = p * ahead;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
    for (const auto& [axis, offset, tan] :
         {std::tuple{0, p * right, tanHorizontal}, std::tuple{1, p * up, tanVertical}}) {
      const double narrowing = parallel ? 0 : tan * depth;
      above[axis] = std::max(above[axis], offset - narrowing);
      below[axis] = std::max(below[axis], -offset - narrowing);
    }
  }
  const Vec sideways = right * ((above[0] - below[0]) / 2) + up * ((above[1] - below[1]) / 2);
  const double reach = std::max((above[0] + below[0]) / (2 * tanHorizontal), (above[1] + below[1]) / (2 * tanVertical));
  const double middle = (nearest + farthest) / 2;
  // In a parallel projection the distance from the pivot only sets the scale.
  const double eyeDepth = parallel ? middle - std::max(reach, sceneRadius() * 1e-3) : std::min(-reach, nearest);
  camera()->frame()->setPivotPoint(sideways + ahead * middle);
  camera()->setPosition(sideways + ahead * eyeDepth);
}

void LevelView::frame(const Vec3& lower, const Vec3& upper) {
  const Vec3 origin = environment_ ? environment_->centre : Vec3{};
  const Vec low = toVec(lower) - toVec(origin);
  const Vec high = toVec(upper) - toVec(origin);
  const Vec middle = (low + high) / 2;
  const double least = kLeastFrame * sceneRadius();
  Vec half = (high - low) / 2;
  if (half.norm() < least) half = Vec(least, least, least) / std::sqrt(3.0);
  std::vector<Vec3> corners;
  for (const double x : {-half.x, half.x}) {
    for (const double y : {-half.y, half.y}) {
      for (const double z : {-half.z, half.z}) corners.push_back({middle.x + x, middle.y + y, middle.z + z});
    }
  }
  fitTo(corners);
}

void LevelView::lookAt(const Vec3& place) {
  const Vec3 origin = environment_ ? environment_->centre : Vec3{};
  const Vec target = toVec(place) - toVec(origin);
  endGlide();
  const CameraPose from = poseNow();
  const double distance = (camera()->position() - camera()->pivotPoint()).norm();
  camera()->frame()->setPivotPoint(target);
  camera()->setPosition(target - camera()->viewDirection() * distance);
  glideFrom(from);
}

void LevelView::frameSelection() {
  if (selection_) {
    frame(selection_->lower, selection_->upper);
    return;
  }
  const QPoint mouse = mapFromGlobal(QCursor::pos());
  const std::optional<SurfacePoint> pointed = rect().contains(mouse) ? pick(mouse) : std::nullopt;
  if (!pointed) {
    fit();
    return;
  }
  // Twice as near, at least.
  const Vec3& p = pointed->point;
  const Vec3 origin = environment_->centre;
  const double reach = (toVec(p) - toVec(origin) - camera()->position()).norm() * std::tan(camera()->fieldOfView() / 2);
  const double half = reach / 2 / std::sqrt(3.0);
  frame({p.x - half, p.y - half, p.z - half}, {p.x + half, p.y + half, p.z + half});
}

}  // namespace footfall
