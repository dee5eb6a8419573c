// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/level/obstacle_tools.hpp"
#include "ui/view/camera/sight_lines.hpp"
#include "ui/view/geometry/obstacle_geometry.hpp"
#include "ui/view/overlays/handle_colours.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

const QString kPreview = QStringLiteral("obstacle.preview");

}  // namespace

PlaceObstacleTool::PlaceObstacleTool(PlacedObstacle::Shape shape, ObstacleContext context, QObject* parent)
    : QObject(parent), shape_(shape), context_(std::move(context)), ground_(context_.view, context_.composer) {}

QString PlaceObstacleTool::hint() const {
  switch (state_) {
    case State::Base:
      return tr("Draw the base; let go to go on with the height. Shift snaps, Esc takes back");
    case State::Height:
      return tr("Move up or down for the height, then click. Shift snaps, Esc takes back");
    case State::Hover:
      break;
  }
  return tr("%1: click a surface, or drag over it to draw the base. Ctrl places another one after it, Shift snaps")
      .arg(ObstacleEditor::nameOf(shape_));
}

void PlaceObstacleTool::setState(State state) {
  if (std::exchange(state_, state) != state) context_.say(hint());
}

// Places are rounded to the grid when `coarse`; nobody needs fractions of a step.
void PlaceObstacleTool::hover(const ViewMouse& mouse) {
  preview_.reset();
  if (const auto ground = ground_.at(mouse.place)) {
    const double step = context_.editor.step(mouse.modifiers.testFlag(Qt::ShiftModifier));
    preview_ = context_.editor.makeDefault(shape_);
    preview_->base = {roundTo(ground->x, step), roundTo(ground->y, step), ground->z};
  }
  refresh();
}

void PlaceObstacleTool::drawBase(const ViewMouse& mouse) {
  if ((mouse.place - pressed_).manhattanLength() >= QApplication::startDragDistance()) drawn_ = true;
  if (!drawn_) return;
  const auto corner = meetHeight(context_.view.rayAt(mouse.place), anchor_.z);
  if (!corner) return;
  const double step = context_.editor.step(mouse.modifiers.testFlag(Qt::ShiftModifier));
  const double x0 = roundTo(anchor_.x, step), y0 = roundTo(anchor_.y, step);
  const double x1 = roundTo(corner->x, step), y1 = roundTo(corner->y, step);
  preview_ = context_.editor.makeDefault(shape_);
  preview_->base = {roundTo((x0 + x1) / 2, step / 2), roundTo((y0 + y1) / 2, step / 2), anchor_.z};
  preview_->size.x = std::max(roundTo(std::abs(x1 - x0), step), step);
  preview_->size.y = std::max(roundTo(std::abs(y1 - y0), step), step);
  if (shape_ == PlacedObstacle::Shape::Ramp) {
    // The ramp rises in the direction of the mouse, along the longer side.
    const bool alongX = preview_->size.x >= preview_->size.y;
    if (!alongX) std::swap(preview_->size.x, preview_->size.y);
    preview_->turn = alongX ? (x1 >= x0 ? 0 : 180) : (y1 >= y0 ? 90 : -90);
  }
  refresh();
}

void PlaceObstacleTool::drawHeight(const ViewMouse& mouse) {
  if (!preview_) return;
  const double step = context_.editor.step(mouse.modifiers.testFlag(Qt::ShiftModifier));
  PlacedObstacle flat = *preview_;
  flat.size.z = step;
  // The height is dragged as if the top had been taken at the bottom, where the mouse left the last corner.
  Ray bottom = context_.view.rayAt(pressed_);
  const auto next = dragged(flat, ObstacleHandle::Top, bottom, context_.view.rayAt(mouse.place),
                            {step, 1, mouse.modifiers.testFlag(Qt::ShiftModifier)});
  if (!next) return;
  preview_->size.z = next->size.z;
  refresh();
}

void PlaceObstacleTool::place(bool more) {
  if (!preview_) return;
  const PlacedObstacle obstacle = *std::exchange(preview_, std::nullopt);
  drawn_ = false;
  setState(State::Hover);
  refresh();
  context_.editor.add(obstacle);
  emit placed(more);
}

bool PlaceObstacleTool::mousePressed(const ViewMouse& mouse) {
  if (mouse.button != Qt::LeftButton) return false;
  if (state_ == State::Height) {
    place(mouse.modifiers.testFlag(Qt::ControlModifier));
    return true;
  }
  hover(mouse);
  const auto ground = ground_.at(mouse.place);
  if (!ground) return false;
  pressed_ = mouse.place;
  anchor_ = *ground;
  drawn_ = false;
  setState(State::Base);
  return true;
}

void PlaceObstacleTool::mouseMoved(const ViewMouse& mouse) {
  switch (state_) {
    case State::Hover:
      hover(mouse);
      return;
    case State::Base:
      drawBase(mouse);
      return;
    case State::Height:
      drawHeight(mouse);
      return;
  }
}

void PlaceObstacleTool::mouseReleased(const ViewMouse& mouse) {
  if (state_ != State::Base) return;
  drawBase(mouse);
  if (!drawn_) {
    place(mouse.modifiers.testFlag(Qt::ControlModifier));
    return;
  }
  pressed_ = mouse.place;
  setState(State::Height);
}

bool PlaceObstacleTool::keyPressed(const QKeyEvent& event) {
  if (state_ == State::Height && (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)) {
    place(event.modifiers().testFlag(Qt::ControlModifier));
    return true;
  }
  if (event.key() != Qt::Key_Escape || state_ == State::Hover) return false;
  preview_.reset();
  drawn_ = false;
  setState(State::Hover);
  refresh();
  return true;
}

void PlaceObstacleTool::mouseLeft() {
  if (state_ != State::Hover) return;
  preview_.reset();
  refresh();
}

void PlaceObstacleTool::ended() {
  preview_.reset();
  drawn_ = false;
  state_ = State::Hover;
  refresh();
}

void PlaceObstacleTool::refresh() {
  if (!preview_) {
    context_.view.removeOverlay(kPreview);
    return;
  }
  const ObstacleShape shape = shapeOf(*preview_);
  ViewOverlay overlay;
  QColor fill = highlightColour();
  fill.setAlphaF(0.3F);
  overlay.surfaces.push_back({shape.triangles, fill});
  overlay.lines.push_back({shape.edges, highlightColour(), 2, outlineColour()});
  overlay.labels.push_back(
      {placeOn(*preview_, {0, 0, preview_->size.z}), context_.editor.units().size(preview_->size)});
  context_.view.setOverlay(kPreview, std::move(overlay));
}

}  // namespace footfall::ui
