// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/level_view.hpp"

#include <QGLViewer/manipulatedCameraFrame.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/view/camera/camera_input.hpp"
#include "ui/view/scene/gl_state.hpp"

namespace footfall::ui {
namespace {

using qglviewer::Camera;
using qglviewer::Vec;

/// The near plane is nearer than by default close to a surface, so that walls of a corridor are not cut away.
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
    : QGLViewer(parent),
      cameraController_(*this, [this](const Ray& ray) { return scene_.placeAlong(ray, viewDirection()); }) {
  setObjectName(QStringLiteral("levelView"));
  const Camera* const usual = camera();
  setCamera(new LevelCamera);  // belongs to QGLViewer
  delete usual;
  setStateFileName(QString());  // the session saves the camera
  setMinimumSize(320, 240);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("View of the level"));
  setMouseTracking(true);
  connect(&pacing_, &FramePacing::frameDue, this, [this] { update(); });
  connect(&pacing_, &FramePacing::sliceDue, this, &LevelView::drawSlice);
  connect(&cameraController_, &CameraController::moved, &pacing_, &FramePacing::move);
  connect(&cameraController_, &CameraController::arrived, &pacing_, &FramePacing::rest);
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
  camera()->frame()->setZoomSensitivity(1.0);
  camera()->frame()->setSpinningSensitivity(1e9);  // the camera stops with the mouse
}

void LevelView::resizeGL(int width, int height) {
  QGLViewer::resizeGL(width, height);
  cameraController_.resized();
}

// --- Content

void LevelView::setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry, bool fitCamera) {
  scene_.setEnvironment(geometry);
  pacing_.forget();
  hovered_.reset();
  cameraController_.setScene(std::move(geometry), fitCamera);
  update();
  emit environmentChanged();
}

void LevelView::replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry) {
  scene_.replaceEnvironment(geometry);
  cameraController_.replaceScene(std::move(geometry));
  update();
}

void LevelView::setBackdrop(BackdropPtr backdrop) {
  scene_.setBackdrop(std::move(backdrop));
  update();
}

void LevelView::setContent(ViewContent content) {
  scene_.setContent(std::move(content));
  update();
}

void LevelView::setParts(const SceneParts& parts) {
  scene_.setParts(parts);
  update();
}

void LevelView::setInside(bool on) {
  scene_.setInside(on);
  update();
}

void LevelView::setMode(ViewMode mode) {
  scene_.setMode(mode);
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
  scene_.setHeights(heights);
  pacing_.move();  // a slider is being dragged
  update();
}

void LevelView::setCutPlane(const std::optional<CutPlane>& cut) {
  scene_.setCutPlane(cut);
  pacing_.move();
  update();
}

void LevelView::setHiddenLayers(const std::set<std::uint32_t>& hidden) {
  scene_.setHiddenLayers(hidden);
  update();
}

void LevelView::setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours) {
  scene_.setCells(std::move(geometry), std::move(colours));
  hovered_.reset();
  update();
}

void LevelView::setCellColours(CellColours colours) {
  renderer_.setCellColours(std::move(colours));
  update();
}

void LevelView::setMarkedCells(const MarkedCells& marked) {
  renderer_.setMarkedCells(marked);
  cameraController_.setSelectionBounds(QStringLiteral("cell"),
                                       marked.selected ? scene_.boundsOfCell(*marked.selected) : std::nullopt);
  update();
}

void LevelView::frameCell(std::size_t cell) {
  if (const std::optional<SceneBox> bounds = scene_.boundsOfCell(cell))
    cameraController_.frame(bounds->lower, bounds->upper);
}

std::optional<std::size_t> LevelView::cellAt(const QPoint& place) const {
  return scene_.cellAlong(sightAt(*camera(), place), viewDirection());
}

void LevelView::hover(std::optional<std::size_t> cell) {
  if (std::exchange(hovered_, cell) != cell || cell) emit cellHovered(cell);
}

// --- Mouse and tools

void LevelView::setTool(ViewTool* tool) {
  if (!mouse_.setTool(tool)) return;
  if (tool) {
    setCursor(tool->cursor());
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
  const Vec3 centre = scene_.centre();
  ray.origin = {ray.origin.x + centre.x, ray.origin.y + centre.y, ray.origin.z + centre.z};
  return ray;
}

std::optional<SurfacePoint> LevelView::pick(const QPoint& place) const {
  std::optional<SurfacePoint> found = scene_.seenAlong(sightAt(*camera(), place), viewDirection());
  if (!found) return std::nullopt;
  const Vec3 centre = scene_.centre();
  found->point = {found->point.x + centre.x, found->point.y + centre.y, found->point.z + centre.z};
  return found;
}

Vec3 LevelView::placeInTheMiddle() const {
  const std::optional<Vec3> seen = scene_.placeAlong(sightAt(*camera(), rect().center()), viewDirection());
  const Vec pivot = camera()->pivotPoint();
  const Vec3 place = seen.value_or(Vec3{pivot.x, pivot.y, pivot.z});
  const Vec3 centre = scene_.centre();
  return {place.x + centre.x, place.y + centre.y, place.z + centre.z};
}

std::optional<QPointF> LevelView::project(const Vec3& place) const {
  return OverlayRenderer::project(place, overlayLook());
}

void LevelView::mousePressEvent(QMouseEvent* event) {
  cameraController_.endGlide();
  if (!mouse_.press(toolMouse(*event))) QGLViewer::mousePressEvent(event);
}

void LevelView::mouseMoveEvent(QMouseEvent* event) {
  if (mouse_.move(toolMouse(*event))) return;
  if (event->buttons() == Qt::NoButton) hover(cellAt(event->pos()));
  QGLViewer::mouseMoveEvent(event);
}

void LevelView::mouseReleaseEvent(QMouseEvent* event) {
  const ToolMouse::Release release = mouse_.release(toolMouse(*event));
  if (release == ToolMouse::Release::Taken) return;
  QGLViewer::mouseReleaseEvent(event);
  if (release != ToolMouse::Release::Clicked || mouse_.click(toolMouse(*event))) return;
  if (scene_.showsCells()) emit cellClicked(cellAt(event->pos()));
}

void LevelView::mouseDoubleClickEvent(QMouseEvent* event) {
  // The first click may have moved the camera, so that another surface is under the mouse now; a tool has handled it as
  // a click.
  if (tool() || scene_.showsCells() || event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier)
    return;
  // libQGLViewer's own binding reads the depth of the frame buffer, which has none of this frame.
  cameraController_.turnAbout(event->pos());
}

void LevelView::leaveEvent(QEvent* event) {
  hover({});
  mouse_.leave();
  QGLViewer::leaveEvent(event);
}

void LevelView::keyPressEvent(QKeyEvent* event) {
  if (mouse_.pressKey(*event)) return;
  if (tool() && event->key() == Qt::Key_Escape) {
    setTool(nullptr);
    return;
  }
  if (!steerByKey(cameraController_, *event)) QWidget::keyPressEvent(event);
}

void LevelView::wheelEvent(QWheelEvent* event) {
  event->accept();
  steerByWheel(cameraController_, *event);
}

bool LevelView::event(QEvent* event) {
  if (event->type() != QEvent::NativeGesture) return QGLViewer::event(event);
  steerByPinch(cameraController_, *static_cast<QNativeGestureEvent*>(event));
  return true;
}

ViewMouse LevelView::toolMouse(const QMouseEvent& event) {
  return {event.pos(), event.button(), event.buttons(), event.modifiers()};
}

// --- Drawing

OverlayRenderer::Look LevelView::overlayLook() const {
  return {modelViewProjection(*camera()), size() * devicePixelRatioF(), static_cast<float>(pixelRatio()),
          scene_.centre()};
}

QVector3D LevelView::viewDirection() const {
  const Vec direction = camera()->viewDirection();
  return {static_cast<float>(direction.x), static_cast<float>(direction.y), static_cast<float>(direction.z)};
}

SceneCamera LevelView::sceneCamera() const {
  SceneCamera scene;
  scene.modelViewProjection = modelViewProjection(*camera());
  const Vec eye = camera()->position();
  scene.eye = QVector3D(static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z));
  scene.viewDirection = viewDirection();
  scene.orthographic = camera()->type() == Camera::ORTHOGRAPHIC;
  scene.devicePixelRatio = static_cast<float>(pixelRatio());
  scene.clip = clipPlanes(shown());
  scene.viewport = size() * devicePixelRatioF();
  return scene;
}

void LevelView::draw() {
  if (!ready_) return;
  const SceneRenderer::Haste haste = pacing_.begin();
  const bool whole = renderer_.draw(sceneCamera(), parts(), haste);
  overlayRenderer_.draw(overlays_, overlayLook());
  context()->functions()->glFinish();  // software OpenGL continues after the call
  pacing_.end(haste, whole, renderer_.wholeMs());
}

// Called between two events of the window, so that it responds while a large picture is drawn.
void LevelView::drawSlice() {
  makeCurrent();
  const bool complete = renderer_.advance(FramePacing::kSliceMs);
  doneCurrent();
  pacing_.endSlice(complete);
}

QImage LevelView::grabFramebuffer() {
  cameraController_.endGlide();
  pacing_.rest();  // nothing is omitted
  pacing_.setUnhurried(true);
  QImage image = QGLViewer::grabFramebuffer();
  pacing_.setUnhurried(false);
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
  // The widget takes the size for one frame that is never shown, because a picture has all content of the view.
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

// Marks and labels come last, because QPainter draws over everything.
void LevelView::paintGL() {
  QGLViewer::paintGL();
  const bool painted = ready_ && std::ranges::any_of(overlays_, [](const auto& entry) {
                         return !entry.second.marks.empty() || !entry.second.labels.empty();
                       });
  if (!painted) return;
  // The painter is not opened on the widget, because painters are redirected while the window is grabbed.
  const GlStateKeeper keeper;
  QOpenGLPaintDevice device(size() * devicePixelRatioF());
  device.setDevicePixelRatio(pixelRatio());
  QPainter painter(&device);
  std::vector<QRectF> covered;
  if (pictureRatio_ == 0) {  // pictures have no widgets in front
    for (const QWidget* widget : findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
      if (widget->isVisible()) covered.emplace_back(widget->geometry());
  }
  OverlayRenderer::paint(painter, overlays_, overlayLook(), std::move(covered));
}

}  // namespace footfall::ui
