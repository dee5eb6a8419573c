// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_view.hpp"

#include <QGLViewer/manipulatedCameraFrame.h>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace footfall {
namespace {

using qglviewer::Camera;
using qglviewer::Quaternion;
using qglviewer::Vec;

constexpr double kSlowFrameMs = 30;
constexpr int kRestMs = 200;      // without movement
constexpr double kMargin = 1.08;  // around the scene when everything is to be in sight

Vec toVec(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

LevelView::LevelView(QWidget* parent) : QGLViewer(parent) {
  setObjectName(QStringLiteral("levelView"));
  setStateFileName(QString());  // the session keeps the camera
  setMinimumSize(320, 240);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, [this] { update(); });
  connect(this, &LevelView::cameraMoved, this, [this] { rest_.start(); });
}

LevelView::~LevelView() {
  if (!ready_) return;
  makeCurrent();
  renderer_.release();
  doneCurrent();
}

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
  setWheelBinding(Qt::NoModifier, CAMERA, ZOOM);
  camera()->frame()->setZoomSensitivity(1.0);
  camera()->frame()->setWheelSensitivity(1.0);
  camera()->frame()->setSpinningSensitivity(1e9);  // the camera stops with the mouse
}

void LevelView::init() {
  bindMouse();
  camera()->setUpVector(Vec(0, 0, 1));
  camera()->frame()->setSceneUpVector(Vec(0, 0, 1));
  camera()->frame()->setRotatesAroundUpVector(true);
  camera()->setFieldOfView(M_PI / 4);
  connect(camera()->frame(), &qglviewer::ManipulatedFrame::manipulated, this, &LevelView::cameraMoved);
  const QString problem = renderer_.initialize();
  ready_ = problem.isEmpty();
  if (!ready_) emit failed(QStringLiteral("cannot show the scene: ") + problem);
}

void LevelView::setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry, bool fitCamera) {
  environment_ = std::move(geometry);
  renderer_.setEnvironment(environment_);
  setContent({});
  setCells(nullptr, {});
  if (environment_) {
    const double radius = toVec(environment_->upper).norm();
    setSceneCenter(Vec(0, 0, 0));
    setSceneRadius(radius > 0 ? radius : 1);
  }
  if (fitCamera) {
    viewOblique();
    fitWhenSized_ = !isVisible();
  }
  update();
}

void LevelView::setContent(ViewContent content) {
  content_ = std::move(content);
  renderer_.setContent(content_);
  update();
}

void LevelView::setParts(const SceneParts& parts) {
  parts_ = parts;
  update();
}

void LevelView::setCut(double fraction) {
  cut_ = fraction;
  update();
}

void LevelView::setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours) {
  cells_ = std::move(geometry);
  hovered_.reset();
  renderer_.setCells(cells_, std::move(colours));
  update();
}

void LevelView::setCellColours(CellColours colours) {
  renderer_.setCellColours(std::move(colours));
  update();
}

void LevelView::setMarkedCells(const MarkedCells& marked) {
  renderer_.setMarkedCells(marked);
  update();
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

std::optional<std::size_t> LevelView::cellAt(const QPoint& place) const {
  if (!parts_.cells || !cells_ || !environment_) return std::nullopt;
  Vec origin, direction;
  camera()->convertClickToLine(place, origin, direction);
  return pickCell({{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}}, *environment_, *cells_,
                  static_cast<double>(cutHeight()));
}

float LevelView::cutHeight() const {
  if (cut_ >= 1 || !environment_) return std::numeric_limits<float>::max();
  const Vec3& lower = environment_->lower;
  const double height = environment_->upper.z - lower.z;
  // A little more, so that a floor at exactly this height is still there.
  return static_cast<float>(lower.z + (cut_ + 1e-4) * height);
}

void LevelView::hover(std::optional<std::size_t> cell) {
  if (std::exchange(hovered_, cell) != cell || cell) emit cellHovered(cell);
}

void LevelView::mousePressEvent(QMouseEvent* event) {
  const bool plain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
  pressed_ = plain ? std::optional(event->pos()) : std::nullopt;
  QGLViewer::mousePressEvent(event);
}

void LevelView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) {
    hover(cellAt(event->pos()));
  } else if (pressed_ && (event->pos() - *pressed_).manhattanLength() >= QApplication::startDragDistance()) {
    pressed_.reset();
  }
  QGLViewer::mouseMoveEvent(event);
}

void LevelView::mouseReleaseEvent(QMouseEvent* event) {
  QGLViewer::mouseReleaseEvent(event);
  if (!std::exchange(pressed_, std::nullopt) || !parts_.cells || !cells_) return;
  emit cellClicked(cellAt(event->pos()));
}

void LevelView::mouseDoubleClickEvent(QMouseEvent* event) {
  // The first click may have moved the camera: what is under the mouse now is not what was meant.
  if (!parts_.cells || !cells_) QGLViewer::mouseDoubleClickEvent(event);
}

void LevelView::leaveEvent(QEvent* event) {
  hover({});
  QGLViewer::leaveEvent(event);
}

void LevelView::resizeGL(int width, int height) {
  QGLViewer::resizeGL(width, height);
  if (fitWhenSized_ && environment_) fitTo(environment_->detailExtremes);
  fitWhenSized_ = false;
}

void LevelView::draw() {
  if (!ready_) return;
  lastFrameBegun_ = std::chrono::steady_clock::now();
  GLdouble modelView[16];
  GLdouble projection[16];
  camera()->getModelViewMatrix(modelView);
  camera()->getProjectionMatrix(projection);
  SceneCamera scene;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += projection[k * 4 + row] * modelView[column * 4 + k];
      scene.modelViewProjection(row, column) = static_cast<float>(sum);
    }
  }
  const Vec eye = camera()->position();
  const Vec direction = camera()->viewDirection();
  scene.eye = QVector3D(static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z));
  scene.viewDirection =
      QVector3D(static_cast<float>(direction.x), static_cast<float>(direction.y), static_cast<float>(direction.z));
  scene.orthographic = camera()->type() == Camera::ORTHOGRAPHIC;
  scene.devicePixelRatio = static_cast<float>(devicePixelRatioF());
  scene.cut = cutHeight();
  scene.viewport = size() * devicePixelRatioF();
  SceneParts parts = parts_;
  const bool hurried = rest_.isActive() && wholeFrameMs_ > kSlowFrameMs;
  if (hurried) parts.outlines = false;
  renderer_.draw(scene, parts, rest_.isActive());
  context()->functions()->glFinish();  // software OpenGL works on after the call
  lastFrameMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - lastFrameBegun_).count();
  if (!hurried) wholeFrameMs_ = lastFrameMs_;
}

void LevelView::lookAlong(const Vec& direction, const Vec& up, bool orthographic) {
  camera()->setType(orthographic ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  const Vec d = direction.unit();
  const Vec right = (d ^ up).unit();
  const Vec upright = right ^ d;
  Quaternion orientation;
  orientation.setFromRotatedBasis(right, upright, -d);
  camera()->setOrientation(orientation);
  if (environment_) fitTo(environment_->detailExtremes);
}

void LevelView::viewFromTop() { lookAlong(Vec(0, 0, -1), Vec(0, 1, 0), true); }

void LevelView::viewOblique() { lookAlong(Vec(0.5, 0.8, -0.9), Vec(0, 0, 1), false); }

void LevelView::fit() {
  if (environment_) fitTo(environment_->extremes);
}

void LevelView::fitTo(const std::vector<Vec3>& points) {
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
  camera()->setPivotPoint(sideways + ahead * middle);
  camera()->setPosition(sideways + ahead * eyeDepth);
  emit cameraMoved();
  rest_.stop();  // one jump is no movement
  update();
}

void LevelView::zoomBy(double factor) {
  const Vec pivot = camera()->pivotPoint();
  camera()->setPosition(pivot + (camera()->position() - pivot) / factor);
  emit cameraMoved();
  update();
}

void LevelView::keyPressEvent(QKeyEvent* event) {
  const double step = 0.08 * (camera()->position() - camera()->pivotPoint()).norm();
  Vec move;
  switch (event->key()) {
    case Qt::Key_Left:
      move = camera()->rightVector() * -step;
      break;
    case Qt::Key_Right:
      move = camera()->rightVector() * step;
      break;
    case Qt::Key_Up:
      move = camera()->upVector() * step;
      break;
    case Qt::Key_Down:
      move = camera()->upVector() * -step;
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  camera()->setPosition(camera()->position() + move);
  camera()->setPivotPoint(camera()->pivotPoint() + move);
  emit cameraMoved();
  update();
}

CameraPose LevelView::cameraPose() const {
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

void LevelView::setCameraPose(const CameraPose& pose) {
  const Vec3 origin = environment_ ? environment_->centre : Vec3{};
  camera()->setType(pose.orthographic ? Camera::ORTHOGRAPHIC : Camera::PERSPECTIVE);
  camera()->setPivotPoint(Vec(pose.pivot.x - origin.x, pose.pivot.y - origin.y, pose.pivot.z - origin.z));
  camera()->setOrientation(
      Quaternion(pose.orientation[0], pose.orientation[1], pose.orientation[2], pose.orientation[3]));
  camera()->setPosition(Vec(pose.position.x - origin.x, pose.position.y - origin.y, pose.position.z - origin.z));
  fitWhenSized_ = false;
  update();
}

}  // namespace footfall
