// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/level_view.hpp"

#include <QGLViewer/manipulatedCameraFrame.h>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/view/gl_state.hpp"

namespace footfall::ui {
namespace {

using qglviewer::Camera;
using qglviewer::Vec;

constexpr double kSlowFrameMs = 30;
constexpr double kSliceMs = 20;  // of drawing between two events
constexpr double kFirstMs = 8;   // of a picture with the frame that first lacks it: enough with a graphics card
constexpr int kRestMs = 200;     // without movement

/// Nearer than usual where one is close to something: in a corridor, walls must not be cut away.
class LevelCamera : public Camera {
 public:
  [[nodiscard]] qreal zNear() const override {
    const qreal usual = Camera::zNear();
    if (type() == ORTHOGRAPHIC) return usual;
    return std::min(usual, std::max(0.02 * (position() - pivotPoint()).norm(), 1e-5 * sceneRadius()));
  }
};

}  // namespace

LevelView::LevelView(QWidget* parent)
    : QGLViewer(parent), cameraController_(*this, [this](const Ray& ray) {
        const std::optional<SurfacePoint> seen = seenAlong(ray);
        return seen ? std::optional(seen->point) : std::nullopt;
      }) {
  setObjectName(QStringLiteral("levelView"));
  const Camera* const usual = camera();
  setCamera(new LevelCamera);  // belongs to QGLViewer
  delete usual;
  setStateFileName(QString());  // the session keeps the camera
  setMinimumSize(320, 240);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("View of the level"));
  setMouseTracking(true);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, [this] { update(); });
  slices_.setSingleShot(true);
  slices_.setInterval(0);
  connect(&slices_, &QTimer::timeout, this, &LevelView::drawOn);
  connect(&cameraController_, &CameraController::moved, this, [this] { rest_.start(); });
  connect(&cameraController_, &CameraController::arrived, &rest_, &QTimer::stop);
}

LevelView::~LevelView() {
  if (!ready_) return;
  makeCurrent();
  overlayRenderer_.release();
  renderer_.release();
  doneCurrent();
}

void LevelView::init() {
  bindMouse();
  camera()->setUpVector(Vec(0, 0, 1));
  camera()->frame()->setSceneUpVector(Vec(0, 0, 1));
  camera()->frame()->setRotatesAroundUpVector(true);
  camera()->setFieldOfView(M_PI / 4);
  connect(camera()->frame(), &qglviewer::ManipulatedFrame::manipulated, &cameraController_, &CameraController::moved);
  QString problem = renderer_.initialize();
  if (problem.isEmpty()) problem = overlayRenderer_.initialize(renderer_.lineProgram());
  ready_ = problem.isEmpty();
  if (!ready_) emit failed(QStringLiteral("cannot show the scene: ") + problem);
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
  camera()->frame()->setZoomSensitivity(1.0);
  camera()->frame()->setSpinningSensitivity(1e9);  // the camera stops with the mouse
}

void LevelView::resizeGL(int width, int height) {
  QGLViewer::resizeGL(width, height);
  cameraController_.resized();
}

void LevelView::setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry, bool fitCamera) {
  environment_ = std::move(geometry);
  renderer_.setEnvironment(environment_);
  wholeFrameMs_ = 0;
  setContent({});
  setCells(nullptr, {});
  cameraController_.setScene(environment_, fitCamera);
  update();
  emit environmentChanged();
}

void LevelView::replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry) {
  environment_ = std::move(geometry);
  renderer_.replaceEnvironment(environment_);
  cameraController_.replaceScene(environment_);
  update();
}

void LevelView::setContent(ViewContent content) {
  content_ = std::move(content);
  renderer_.setContent(content_);
  update();
}

void LevelView::setParts(const SceneParts& parts) {
  const ViewMode mode = parts_.mode;
  const bool inside = parts_.inside;
  parts_ = parts;
  parts_.mode = mode;
  parts_.inside = inside;
  update();
}

void LevelView::setInside(bool on) {
  parts_.inside = on;
  update();
}

void LevelView::setMode(ViewMode mode) {
  parts_.mode = mode;
  update();
}

void LevelView::setField(std::shared_ptr<const FieldGeometry> field, const FieldScale& scale) {
  renderer_.setField(std::move(field));
  setFieldScale(scale);
}

void LevelView::setFieldScale(const FieldScale& scale) {
  renderer_.setFieldScale(scale);
  update();
}

void LevelView::setSources(std::shared_ptr<const NavigationMeshGeometry> sources) {
  renderer_.setSources(std::move(sources));
  update();
}

void LevelView::setHeights(const HeightRange& heights) {
  heights_ = heights;
  rest_.start();  // a slider is dragged
  update();
}

void LevelView::setCutPlane(const std::optional<CutPlane>& cut) {
  cut_ = cut;
  rest_.start();
  update();
}

void LevelView::setHiddenLayers(const std::set<std::uint32_t>& hidden) {
  hidden_ = hidden;
  renderer_.setHiddenLayers(hidden);
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
  cameraController_.setSelectionBounds(QStringLiteral("cell"),
                                       marked.selected ? boundsOf(*marked.selected) : std::nullopt);
  update();
}

std::optional<SceneBox> LevelView::boundsOf(std::size_t cell) const {
  if (!cells_ || !environment_) return std::nullopt;
  return boundsOfCell(*cells_, cell, environment_->centre);
}

void LevelView::frameCell(std::size_t cell) {
  if (const std::optional<SceneBox> bounds = boundsOf(cell)) cameraController_.frame(bounds->lower, bounds->upper);
}

std::optional<std::size_t> LevelView::cellAt(const QPoint& place) const {
  if (!parts_.cells || !cells_ || !environment_) return std::nullopt;
  const PickedScene scene = pickedScene();
  ShownSpace space = scene.space;
  space.shows = shownTriangles(scene);
  return pickCell(sightAt(*camera(), place), *environment_, *cells_, space);
}

ShownSpace LevelView::shown() const { return environment_ ? shownSpace(heights_, cut_, *environment_) : ShownSpace(); }

PickedScene LevelView::pickedScene() const {
  return {*environment_,
          content_,
          hidden_,
          sceneRule(parts_, content_, environment_.get(), sceneCamera().viewDirection),
          parts_.cells && cells_,
          shown()};
}

std::optional<SurfacePoint> LevelView::seenAlong(const Ray& sceneRay) const {
  return environment_ ? pickSeen(sceneRay, pickedScene()) : std::nullopt;
}

void LevelView::hover(std::optional<std::size_t> cell) {
  if (std::exchange(hovered_, cell) != cell || cell) emit cellHovered(cell);
}

// --- Mouse and tools

void LevelView::setTool(ViewTool* tool) {
  if (tool == tool_) return;
  ViewTool* const before = std::exchange(tool_, tool);
  toolHasMouse_ = false;
  if (before) before->ended();
  if (tool_) {
    setCursor(tool_->cursor());
  } else {
    unsetCursor();
  }
  emit toolChanged();
  update();
}

void LevelView::setOverlay(const QString& name, ViewOverlay overlay) {
  overlays_[name] = std::move(overlay);
  update();
}

void LevelView::removeOverlay(const QString& name) {
  if (overlays_.erase(name) > 0) update();
}

Ray LevelView::rayAt(const QPoint& place) const {
  Ray ray = sightAt(*camera(), place);
  const Vec3 centre = environment_ ? environment_->centre : Vec3{};
  ray.origin = {ray.origin.x + centre.x, ray.origin.y + centre.y, ray.origin.z + centre.z};
  return ray;
}

std::optional<SurfacePoint> LevelView::pick(const QPoint& place) const {
  std::optional<SurfacePoint> found = seenAlong(sightAt(*camera(), place));
  if (!found) return std::nullopt;
  const Vec3& centre = environment_->centre;
  found->point = {found->point.x + centre.x, found->point.y + centre.y, found->point.z + centre.z};
  return found;
}

std::optional<QPointF> LevelView::project(const Vec3& place) const {
  return OverlayRenderer::project(place, overlayLook());
}

void LevelView::mousePressEvent(QMouseEvent* event) {
  const bool plain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
  cameraController_.endGlide();
  pressed_ = plain ? std::optional(event->pos()) : std::nullopt;
  toolHasMouse_ = tool_ && tool_->mousePressed(toolMouse(*event));
  if (toolHasMouse_) {
    pressed_.reset();
    return;
  }
  QGLViewer::mousePressEvent(event);
}

void LevelView::mouseMoveEvent(QMouseEvent* event) {
  if (tool_ && (toolHasMouse_ || event->buttons() == Qt::NoButton)) {
    tool_->mouseMoved(toolMouse(*event));
    if (toolHasMouse_) return;
  }
  if (event->buttons() == Qt::NoButton) {
    hover(cellAt(event->pos()));
  } else if (pressed_ && (event->pos() - *pressed_).manhattanLength() >= QApplication::startDragDistance()) {
    pressed_.reset();
  }
  QGLViewer::mouseMoveEvent(event);
}

void LevelView::mouseReleaseEvent(QMouseEvent* event) {
  if (std::exchange(toolHasMouse_, false)) {
    if (tool_) tool_->mouseReleased(toolMouse(*event));
    return;
  }
  QGLViewer::mouseReleaseEvent(event);
  if (!std::exchange(pressed_, std::nullopt)) return;
  if (tool_) {
    tool_->clicked(toolMouse(*event));
  } else if (parts_.cells && cells_) {
    emit cellClicked(cellAt(event->pos()));
  }
}

void LevelView::mouseDoubleClickEvent(QMouseEvent* event) {
  // The first click may have moved the camera: what is under the mouse now is not what was meant. A tool has taken it
  // as a click.
  if (!tool_ && (!parts_.cells || !cells_)) QGLViewer::mouseDoubleClickEvent(event);
}

void LevelView::leaveEvent(QEvent* event) {
  hover({});
  if (tool_) tool_->mouseLeft();
  QGLViewer::leaveEvent(event);
}

void LevelView::keyPressEvent(QKeyEvent* event) {
  if (tool_ && tool_->keyPressed(*event)) return;
  if (tool_ && event->key() == Qt::Key_Escape) {
    setTool(nullptr);
    return;
  }
  if (!cameraController_.keyPressed(*event)) QWidget::keyPressEvent(event);
}

void LevelView::wheelEvent(QWheelEvent* event) {
  event->accept();
  cameraController_.wheel(*event);
}

bool LevelView::event(QEvent* event) {
  if (event->type() != QEvent::NativeGesture) return QGLViewer::event(event);
  cameraController_.pinch(*static_cast<QNativeGestureEvent*>(event));
  return true;
}

ViewMouse LevelView::toolMouse(const QMouseEvent& event) {
  return {event.pos(), event.button(), event.buttons(), event.modifiers()};
}

// --- Drawing

OverlayRenderer::Look LevelView::overlayLook() const {
  return {modelViewProjection(*camera()), size() * devicePixelRatioF(), static_cast<float>(pixelRatio()),
          environment_ ? environment_->centre : Vec3{}};
}

SceneCamera LevelView::sceneCamera() const {
  SceneCamera scene;
  scene.modelViewProjection = modelViewProjection(*camera());
  const Vec eye = camera()->position();
  const Vec direction = camera()->viewDirection();
  scene.eye = QVector3D(static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z));
  scene.viewDirection =
      QVector3D(static_cast<float>(direction.x), static_cast<float>(direction.y), static_cast<float>(direction.z));
  scene.orthographic = camera()->type() == Camera::ORTHOGRAPHIC;
  scene.devicePixelRatio = static_cast<float>(pixelRatio());
  scene.clip = clipPlanes(shown());
  scene.viewport = size() * devicePixelRatioF();
  return scene;
}

void LevelView::draw() {
  if (!ready_) return;
  lastFrameBegun_ = std::chrono::steady_clock::now();
  SceneRenderer::Haste haste;
  haste.moving = rest_.isActive();
  // What is not known yet may take long.
  haste.hurried = wholeFrameMs_ == 0 || wholeFrameMs_ > kSlowFrameMs;
  haste.ms = unhurried_ ? std::numeric_limits<double>::infinity() : kFirstMs;
  whole_ = renderer_.draw(sceneCamera(), parts_, haste);
  overlayRenderer_.draw(overlays_, overlayLook());
  context()->functions()->glFinish();  // software OpenGL works on after the call
  lastFrameMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - lastFrameBegun_).count();
  if (!haste.moving && whole_) wholeFrameMs_ = renderer_.wholeMs();
  if (haste.moving && !haste.hurried) wholeFrameMs_ = lastFrameMs_;
  if (whole_) {
    slices_.stop();
  } else {
    slices_.start();
  }
}

// Between two events of the window, so that it answers while a large picture is drawn.
void LevelView::drawOn() {
  if (rest_.isActive()) return;
  makeCurrent();
  const bool complete = renderer_.advance(kSliceMs);
  doneCurrent();
  if (complete) {
    update();
  } else {
    slices_.start();
  }
}

QImage LevelView::grabFramebuffer() {
  cameraController_.endGlide();
  rest_.stop();  // nothing is left out
  unhurried_ = true;
  QImage image = QGLViewer::grabFramebuffer();
  unhurried_ = false;
  return image;
}

qreal LevelView::pixelRatio() const { return pictureRatio_ > 0 ? pictureRatio_ : devicePixelRatioF(); }

QImage LevelView::picture(const QSize& pixels, double ratio, PictureCamera from) {
  if (!ready_ || pixels.isEmpty()) return {};
  makeCurrent();
  GLint most = 0;
  context()->functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  doneCurrent();
  if (std::max(pixels.width(), pixels.height()) > most) return {};
  // The widget takes the size for one frame that is never shown: a picture has all that the view has.
  const QRect place = geometry();
  const QSize logical = (QSizeF(pixels) / devicePixelRatioF()).toSize();
  cameraController_.endGlide();
  cameraController_.setForPicture(true);
  pictureRatio_ = ratio;
  const CameraPose pose = cameraController_.pose();
  resize(logical);
  if (from == PictureCamera::Top) cameraController_.viewFromTop();
  if (from == PictureCamera::Oblique) cameraController_.viewOblique();
  QImage image = grabFramebuffer();
  pictureRatio_ = 0;
  setGeometry(place);
  if (from != PictureCamera::AsSeen) cameraController_.glideTo(pose);
  cameraController_.setForPicture(false);
  image.setDevicePixelRatio(1);
  return image.convertToFormat(QImage::Format_RGB32);  // opaque, as on the screen
}

// Marks and labels come last: QPainter draws over everything.
void LevelView::paintGL() {
  QGLViewer::paintGL();
  const bool painted = ready_ && std::ranges::any_of(overlays_, [](const auto& entry) {
                         return !entry.second.marks.empty() || !entry.second.labels.empty();
                       });
  if (!painted) return;
  // Not on the widget: while the window is grabbed, its painters go elsewhere.
  const GlStateKeeper keeper;
  QOpenGLPaintDevice device(size() * devicePixelRatioF());
  device.setDevicePixelRatio(pixelRatio());
  QPainter painter(&device);
  OverlayRenderer::paint(painter, overlays_, overlayLook());
}

}  // namespace footfall::ui
