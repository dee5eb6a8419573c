// SPDX-License-Identifier: GPL-3.0-or-later
// LevelView's camera: how mouse and keys move it, and where it looks from.
#include <QGLViewer/manipulatedCameraFrame.h>

#include <QCursor>
#include <QKeyEvent>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "ui/view/level_view.hpp"

namespace footfall::ui {
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

// --- The camera of a frame

void LevelView::resizeGL(int width, int height) {
  QGLViewer::resizeGL(width, height);
  if (pictureRatio_ > 0) return;  // of a picture of another size; the view stays where it is
  const Placed now{QRect(mapTo(window(), QPoint(0, 0)), size()), window()->size()};
  const std::optional<Placed> before = std::exchange(placed_, now);
  if (fitWhenSized_ && environment_) {
    standBefore(environment_->detailExtremes);
    opened_ = poseNow();
    moved();
    rest_.stop();
  } else if (before && isVisible() && before->window == now.window && before->inWindow != now.inWindow) {
    keepPicture(*before, now);
  }
  fitWhenSized_ = false;
}

QMatrix4x4 LevelView::modelViewProjection() const {
  GLdouble modelView[16];
  GLdouble projection[16];
  camera()->getModelViewMatrix(modelView);
  camera()->getProjectionMatrix(projection);
  QMatrix4x4 product;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += projection[k * 4 + row] * modelView[column * 4 + k];
      product(row, column) = static_cast<float>(sum);
    }
  }
  return product;
}

OverlayRenderer::Look LevelView::overlayLook() const {
  return {modelViewProjection(), size() * devicePixelRatioF(), static_cast<float>(pixelRatio()),
          environment_ ? environment_->centre : Vec3{}};
}

SceneCamera LevelView::sceneCamera() const {
  SceneCamera scene;
  scene.modelViewProjection = modelViewProjection();
  const Vec eye = camera()->position();
  const Vec direction = camera()->viewDirection();
  scene.eye = QVector3D(static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z));
  scene.viewDirection =
      QVector3D(static_cast<float>(direction.x), static_cast<float>(direction.y), static_cast<float>(direction.z));
  scene.orthographic = camera()->type() == Camera::ORTHOGRAPHIC;
  scene.devicePixelRatio = static_cast<float>(pixelRatio());
  scene.clip = clipPlanes();
  scene.viewport = size() * devicePixelRatioF();
  return scene;
}

// --- Where it looks from

// Between the floors of the cell rather than between the sky and the cellar.
std::optional<SceneBox> LevelView::boundsOfCell(std::size_t cell) const {
  if (!cells_ || !environment_ || cell >= cells_->boxes.size()) return std::nullopt;
  const CellBox& box = cells_->boxes[cell];
  float lowest = std::numeric_limits<float>::max();
  float highest = std::numeric_limits<float>::lowest();
  for (std::size_t v = cells_->firstVertex[cell]; v < cells_->firstVertex[cell + 1]; ++v) {
    lowest = std::min(lowest, cells_->surface[v].position[2]);
    highest = std::max(highest, cells_->surface[v].position[2]);
  }
  if (lowest > highest) lowest = highest = box.lower[2];
  const Vec3& c = environment_->centre;
  return SceneBox{{box.lower[0] + c.x, box.lower[1] + c.y, lowest + c.z},
                  {box.upper[0] + c.x, box.upper[1] + c.y, highest + c.z}};
}

void LevelView::frameCell(std::size_t cell) {
  if (const std::optional<SceneBox> bounds = boundsOfCell(cell)) frame(bounds->lower, bounds->upper);
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

void LevelView::refit() {
  if (!environment_ || glide_ || !opened_ || !(poseNow() == *opened_)) return;
  standBefore(environment_->detailExtremes);
  opened_ = poseNow();
  moved();
  rest_.stop();
}

void LevelView::fit() {
  if (environment_) fitTo(environment_->extremes);
}

namespace {

// Around points in a plane, counter-clockwise (Andrew 1979).
QPolygonF hullOf(std::vector<QPointF> points) {
  std::ranges::sort(points,
                    [](const QPointF& a, const QPointF& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  const auto turns = [](const QPointF& a, const QPointF& b, const QPointF& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  QPolygonF hull;
  for (int side = 0; side < 2; ++side) {
    const qsizetype first = hull.size();
    for (const QPointF& p : points) {
      while (hull.size() >= first + 2 && turns(hull[hull.size() - 2], hull.back(), p) <= 0) hull.removeLast();
      hull << p;
    }
    if (!hull.isEmpty()) hull.removeLast();
    std::ranges::reverse(points);
  }
  return hull;
}

// Ways to leave everything in `covered` outside, by one margin of the view for each; those that leave most come first.
std::vector<QMarginsF> marginsAround(const std::vector<QRect>& covered, const QSize& view) {
  std::vector<QMarginsF> ways{{}};
  for (const QRect& rect : covered) {
    const std::vector<QMarginsF> before = ways;
    for (const QMarginsF& way : before) {
      const double right = view.width() - rect.left();
      const double bottom = view.height() - rect.top();
      ways.push_back(way | QMarginsF(rect.right() + 1, 0, 0, 0));
      ways.push_back(way | QMarginsF(0, rect.bottom() + 1, 0, 0));
      ways.push_back(way | QMarginsF(0, 0, right, 0));
      ways.push_back(way | QMarginsF(0, 0, 0, bottom));
    }
  }
  const auto left = [&](const QMarginsF& m) {
    return std::max(0.0, view.width() - m.left() - m.right()) * std::max(0.0, view.height() - m.top() - m.bottom());
  };
  constexpr double kLeast = 0.25;  // of the view: with less, one would see little of much
  std::erase_if(ways, [&](const QMarginsF& way) { return left(way) < kLeast * view.width() * view.height(); });
  std::ranges::stable_sort(ways, [&](const QMarginsF& a, const QMarginsF& b) { return left(a) > left(b); });
  return ways;
}

}  // namespace

bool LevelView::anyCovered(const std::vector<Vec3>& points) const {
  std::vector<QPointF> places;
  const OverlayRenderer::Look look = overlayLook();
  for (const Vec3& p : points) {
    const auto place = OverlayRenderer::project({p.x + look.centre.x, p.y + look.centre.y, p.z + look.centre.z}, look);
    if (place) places.push_back(*place);
  }
  const QPolygonF hull = hullOf(std::move(places));
  return std::ranges::any_of(covered_, [&](const QRect& rect) { return hull.intersects(QPolygonF(QRectF(rect))); });
}

// As large as it can be beside what lies over the view; over a picture nothing does.
void LevelView::standBefore(const std::vector<Vec3>& points) {
  const std::vector<QRect> covered = pictureRatio_ > 0 ? std::vector<QRect>() : covered_;
  for (const QMarginsF& free : marginsAround(covered, size())) {
    standBefore(points, free);
    if (covered.empty() || !anyCovered(points)) return;
  }
  standBefore(points, {});
}

void LevelView::standBefore(const std::vector<Vec3>& points, const QMarginsF& free) {
  if (points.empty()) return;
  const Vec right = camera()->rightVector();
  const Vec up = camera()->upVector();
  const Vec ahead = camera()->viewDirection();
  const bool parallel = camera()->type() == Camera::ORTHOGRAPHIC;
  // In a parallel projection, libQGLViewer takes the scale from the shorter side.
  const double shorter = parallel ? std::min(1.0, width() / std::max(1.0, static_cast<double>(height()))) : 1;
  const double tanVertical = std::tan(camera()->fieldOfView() / 2) / kMargin / std::max(0.1, shorter);
  const double tanHorizontal = tanVertical * std::max(0.1, width() / std::max(1.0, static_cast<double>(height())));
  // Of the sides of the view that are left, from the middle: to the right and up, and to the left and down.
  const auto part = [](double margin, int all) { return 1 - 2 * margin / std::max(1, all); };
  const std::array<double, 2> tanAbove{tanHorizontal * part(free.right(), width()),
                                       tanVertical * part(free.top(), height())};
  const std::array<double, 2> tanBelow{tanHorizontal * part(free.left(), width()),
                                       tanVertical * part(free.bottom(), height())};

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
    for (const auto& [axis, offset] : {std::pair{0, p * right}, std::pair{1, p * up}}) {
      above[axis] = std::max(above[axis], offset - (parallel ? 0 : tanAbove[axis] * depth));
      below[axis] = std::max(below[axis], -offset - (parallel ? 0 : tanBelow[axis] * depth));
    }
  }
  const auto reachOf = [&](std::size_t axis) {
    return (above[axis] + below[axis]) / std::max(1e-3, tanAbove[axis] + tanBelow[axis]);
  };
  const double reach = std::max(reachOf(0), reachOf(1));
  const double middle = (nearest + farthest) / 2;
  // In a parallel projection the distance from the pivot only sets the scale.
  const double scale = std::max(reach, sceneRadius() * 1e-3);
  const double eyeDepth = parallel ? middle - scale : std::min(-reach, nearest);
  const auto sidewaysAt = [&](double away) {
    const auto along = [&](std::size_t axis) {
      return (above[axis] - below[axis] - (tanAbove[axis] - tanBelow[axis]) * away) / 2;
    };
    return right * along(0) + up * along(1);
  };
  const Vec sideways = sidewaysAt(parallel ? scale : -eyeDepth);
  // The pivot is in the middle of what is left of the view.
  const double away = parallel ? scale : middle - eyeDepth;
  const Vec aside = right * ((tanAbove[0] - tanBelow[0]) / 2 * away) + up * ((tanAbove[1] - tanBelow[1]) / 2 * away);
  camera()->frame()->setPivotPoint(sideways + aside + ahead * middle);
  camera()->setPosition(sideways + ahead * eyeDepth);
}

// A dock has come or gone: what was at a place of the screen stays there, as large as it was (at the pivot's depth).
void LevelView::keepPicture(const Placed& before, const Placed& now) {
  endGlide();
  if (before.inWindow.height() <= 0 || now.inWindow.height() <= 0) return;
  const Vec pivot = camera()->pivotPoint();
  const Vec ahead = camera()->viewDirection();
  const double depth = (pivot - camera()->position()) * ahead;
  if (!(depth > 0)) return;
  // In a parallel projection, libQGLViewer takes the scale from the shorter side.
  const auto extent = [this](const QRect& rect) {
    return orthographic() ? std::min(rect.width(), rect.height()) : rect.height();
  };
  const double scaled = depth * extent(now.inWindow) / extent(before.inWindow);
  const double unit = 2 * std::tan(camera()->fieldOfView() / 2) * scaled / extent(now.inWindow);
  const QPointF way = QRectF(now.inWindow).center() - QRectF(before.inWindow).center();
  const Vec move = camera()->rightVector() * (way.x() * unit) - camera()->upVector() * (way.y() * unit);
  camera()->setPosition(camera()->position() - ahead * (scaled - depth) + move);
  update();
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

void LevelView::setSelectionBounds(const QString& owner, const std::optional<SceneBox>& bounds) {
  const auto known = std::ranges::find(selections_, owner, &std::pair<QString, SceneBox>::first);
  if (known != selections_.end()) {
    if (bounds && known->second == *bounds) return;
    selections_.erase(known);
  }
  if (bounds) selections_.emplace_back(owner, *bounds);
}

void LevelView::frameSelection() {
  if (!selections_.empty()) {
    const SceneBox box = selections_.back().second;
    frame(box.lower, box.upper);
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

}  // namespace footfall::ui
