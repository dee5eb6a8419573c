// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <utility>

#include "ui/level/obstacle_tools.hpp"
#include "ui/view/camera/sight_lines.hpp"
#include "ui/view/geometry/obstacle_geometry.hpp"

namespace footfall::ui {
namespace {

const QString kHandles = QStringLiteral("obstacle.handles");

QString textOf(std::optional<ObstacleHandle> handle) {
  using Handle = ObstacleHandle;
  if (!handle) return SelectObstacleTool::tr("Move %1");
  switch (*handle) {
    case Handle::MoveX:
    case Handle::MoveY:
    case Handle::MoveZ:
    case Handle::MovePlan:
      return SelectObstacleTool::tr("Move %1");
    case Handle::Turn:
      return SelectObstacleTool::tr("Turn %1");
    default:
      return SelectObstacleTool::tr("Resize %1");
  }
}

}  // namespace

SelectObstacleTool::SelectObstacleTool(ObstacleContext context, QObject* parent)
    : QObject(parent), context_(std::move(context)), ground_(context_.view, context_.composer) {
  connect(&context_.editor, &ObstacleEditor::changed, this, [this] {
    if (!context_.editor.dragging()) hold_.reset();  // an undo ended the drag
    refresh();
  });
  connect(&context_.view.cameraController(), &CameraController::moved, this, &SelectObstacleTool::refresh);
  connect(&context_.view, &LevelView::toolChanged, this, &SelectObstacleTool::refresh);
}

QString SelectObstacleTool::hint() const {
  return tr(
      "Click an obstacle; drag its handles to move, turn and resize it. Shift snaps, Alt drags a copy, Esc takes "
      "back");
}

std::optional<ObstacleGizmo> SelectObstacleTool::gizmo() const {
  const PlacedObstacle* obstacle = context_.editor.selected();
  const auto geometry = context_.view.environmentGeometry();
  if (!obstacle || !geometry) return std::nullopt;
  const Vec3 middle = placeOn(*obstacle, {0, 0, obstacle->size.z / 2});
  const Vec3& c = geometry->centre;
  GizmoView view;
  view.project = [&levelView = context_.view](const Vec3& place) { return levelView.project(place); };
  view.unitsPerPixel = static_cast<double>(
      context_.view.camera()->pixelGLRatio(qglviewer::Vec(middle.x - c.x, middle.y - c.y, middle.z - c.z)));
  return ObstacleGizmo(*obstacle, view);
}

void SelectObstacleTool::beginHold(const ViewMouse& mouse, std::uint32_t id, std::optional<ObstacleHandle> handle,
                                   double height) {
  if (mouse.modifiers.testFlag(Qt::AltModifier)) {
    context_.editor.beginDragOfCopy(id);
  } else {
    context_.editor.beginDrag(id, textOf(handle));
  }
  if (const PlacedObstacle* start = context_.editor.selected())
    hold_ = Hold{handle, context_.view.rayAt(mouse.place), height, *start};
  refresh();
}

bool SelectObstacleTool::mousePressed(const ViewMouse& mouse) {
  if (mouse.button != Qt::LeftButton) return false;
  if (const PlacedObstacle* selected = context_.editor.selected()) {
    if (const auto handle = gizmo()->at(mouse.place)) {
      beginHold(mouse, selected->id, handle, 0);
      return true;
    }
  }
  const auto id = ground_.obstacleAt(mouse.place);
  if (!id || mouse.modifiers.testFlag(Qt::ControlModifier)) return false;
  const auto seen = context_.view.pick(mouse.place);
  context_.editor.select(id);
  beginHold(mouse, *id, std::nullopt, seen->point.z);
  return true;
}

// Puts the obstacle on the ground at its new place, when there is one within reach: a metre up, any depth down.
void SelectObstacleTool::stick(PlacedObstacle& obstacle, double from) const {
  const double reach = context_.editor.makeDefault(PlacedObstacle::Shape::Box).size.z;
  const auto ground = ground_.under({obstacle.base.x, obstacle.base.y, from + reach}, obstacle.id);
  if (ground) obstacle.base.z = ground->z;
}

std::optional<PlacedObstacle> SelectObstacleTool::held(const ViewMouse& mouse) const {
  const bool coarse = mouse.modifiers.testFlag(Qt::ShiftModifier);
  const DragSteps steps{context_.editor.step(coarse), coarse ? 15.0 : 1.0, coarse};
  const Ray to = context_.view.rayAt(mouse.place);
  std::optional<PlacedObstacle> next;
  if (hold_->handle) {
    next = dragged(hold_->start, *hold_->handle, hold_->from, to, steps);
  } else {
    // The body moves in the plane through the place where it was taken.
    PlacedObstacle raised = hold_->start;
    raised.size.z = 0;
    raised.base.z = hold_->height;
    next = dragged(raised, ObstacleHandle::MovePlan, hold_->from, to, steps);
    if (next) {
      next->base.z = hold_->start.base.z;
      next->size.z = hold_->start.size.z;
    }
  }
  const bool sideways = !hold_->handle || *hold_->handle == ObstacleHandle::MoveX ||
                        *hold_->handle == ObstacleHandle::MoveY || *hold_->handle == ObstacleHandle::MovePlan;
  if (!next || !sideways || !sticking_) return next;
  if (next->base == hold_->start.base) return next;
  const PlacedObstacle* live = context_.editor.selected();
  stick(*next, live ? live->base.z : next->base.z);
  return next;
}

void SelectObstacleTool::mouseMoved(const ViewMouse& mouse) {
  if (hold_) {
    if (const auto next = held(mouse)) context_.editor.dragTo(*next);
    return;
  }
  const auto handles = gizmo();
  const auto handle = handles ? handles->at(mouse.place) : std::nullopt;
  context_.view.setCursor(handle ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (std::exchange(hovered_, handle) != handle) refresh();
}

void SelectObstacleTool::mouseReleased(const ViewMouse& mouse) {
  if (!hold_) return;
  if (const auto next = held(mouse)) context_.editor.dragTo(*next);
  hold_.reset();
  context_.editor.endDrag();
}

void SelectObstacleTool::clicked(const ViewMouse& mouse) { context_.editor.select(ground_.obstacleAt(mouse.place)); }

void SelectObstacleTool::mouseLeft() {
  if (hold_ || !std::exchange(hovered_, std::nullopt)) return;
  refresh();
}

// Moves along the axes of the environment that are nearest to the screen's axes.
bool SelectObstacleTool::nudge(int key, bool coarse) {
  const PlacedObstacle* selected = context_.editor.selected();
  if (!selected || hold_) return false;
  const qglviewer::Vec right = context_.view.camera()->rightVector();
  const std::array<int, 2> onRight = std::abs(right.x) >= std::abs(right.y) ? std::array{right.x >= 0 ? 1 : -1, 0}
                                                                            : std::array{0, right.y >= 0 ? 1 : -1};
  std::array<int, 3> way{};
  switch (key) {
    case Qt::Key_Right:
      way = {onRight[0], onRight[1], 0};
      break;
    case Qt::Key_Left:
      way = {-onRight[0], -onRight[1], 0};
      break;
    case Qt::Key_Up:
      way = {-onRight[1], onRight[0], 0};
      break;
    case Qt::Key_Down:
      way = {onRight[1], -onRight[0], 0};
      break;
    case Qt::Key_PageUp:
      way = {0, 0, 1};
      break;
    case Qt::Key_PageDown:
      way = {0, 0, -1};
      break;
    default:
      return false;
  }
  // One fine step would be invisible, so ten are used.
  const double step = coarse ? context_.editor.step(true) : 10 * context_.editor.step(false);
  PlacedObstacle next = *selected;
  const auto moved = [&](double place, int by) { return by == 0 ? place : roundTo(place + by * step, step / 1000); };
  next.base = {moved(next.base.x, way[0]), moved(next.base.y, way[1]), moved(next.base.z, way[2])};
  if (sticking_ && way[2] == 0) stick(next, next.base.z);
  context_.editor.changeSoon(next, tr("Move %1"));
  return true;
}

bool SelectObstacleTool::keyPressed(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape && hold_) {
    hold_.reset();
    context_.editor.cancelDrag();
    return true;
  }
  if (event.modifiers().testFlag(Qt::ControlModifier) || event.modifiers().testFlag(Qt::AltModifier)) return false;
  return nudge(event.key(), event.modifiers().testFlag(Qt::ShiftModifier));
}

void SelectObstacleTool::ended() {
  hold_.reset();
  hovered_.reset();
  context_.editor.endDrag();
  context_.view.removeOverlay(kHandles);
}

void SelectObstacleTool::refresh() {
  if (context_.view.tool() != this) return;
  const auto handles = gizmo();
  if (!handles) {
    context_.view.removeOverlay(kHandles);
    return;
  }
  context_.view.setOverlay(kHandles, handles->overlay(hold_ && hold_->handle ? hold_->handle : hovered_));
}

}  // namespace footfall::ui
