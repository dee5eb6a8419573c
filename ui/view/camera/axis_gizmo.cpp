// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/axis_gizmo.hpp"

#include <QApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QQuaternion>
#include <QToolTip>
#include <QVector3D>
#include <algorithm>
#include <utility>

namespace footfall::ui {
namespace {

constexpr int kSide = 92;
constexpr double kReach = 32;  // pixels from the middle to the ends
constexpr double kRadius = 9;  // radius of the discs
constexpr double kGizmoDegreesPerPixel = 0.6;

/// One of the level's axes (Z up), with the view sides at its ends.
struct Axis {
  QVector3D direction;
  ViewSide side, far;
};

const std::array<Axis, 3> kAxes = {{{{1, 0, 0}, ViewSide::Right, ViewSide::Left},
                                    {{0, 1, 0}, ViewSide::Back, ViewSide::Front},
                                    {{0, 0, 1}, ViewSide::Top, ViewSide::Bottom}}};

// Vermilion, green and blue of Okabe and Ito, for the file's x, y and z.
const std::array<QColor, 3> kColours = {QColor(213, 94, 0), QColor(0, 138, 100), QColor(0, 114, 178)};

QString helpOf(ViewSide side) {
  switch (side) {
    case ViewSide::Top:
      return AxisGizmo::tr("From the top");
    case ViewSide::Bottom:
      return AxisGizmo::tr("From below");
    case ViewSide::Front:
      return AxisGizmo::tr("From the front");
    case ViewSide::Back:
      return AxisGizmo::tr("From the back");
    case ViewSide::Left:
      return AxisGizmo::tr("From the left");
    case ViewSide::Right:
      return AxisGizmo::tr("From the right");
  }
  return {};
}

}  // namespace

AxisGizmo::AxisGizmo(LevelView& view) : QWidget(&view), view_(view), camera_(view.cameraController()) {
  setObjectName(QStringLiteral("axisGizmo"));
  setAccessibleName(tr("Axes of the view"));
  setFixedSize(kSide, kSide);
  setMouseTracking(true);
  setFocusPolicy(Qt::NoFocus);  // the view keeps the keyboard focus
  connect(&view_, &QOpenGLWidget::frameSwapped, this, [this] {
    if (camera_.pose().orientation != painted_) update();
  });
}

void AxisGizmo::setUnits(const LevelUnits& units) {
  units_ = units;
  setAccessibleDescription(tr("Axes of the file: %1").arg(units.upText()));
  update();
}

std::vector<AxisGizmo::End> AxisGizmo::ends() const {
  const auto& q = camera_.pose().orientation;
  const QQuaternion turn(static_cast<float>(q[3]), static_cast<float>(q[0]), static_cast<float>(q[1]),
                         static_cast<float>(q[2]));
  std::vector<End> found;
  for (int i = 0; i < 3; ++i) {
    const Axis& axis = kAxes[static_cast<std::size_t>(i)];
    const LevelUnits::FileAxis file = units_.fileAxis(i);
    const QColor& colour = kColours[static_cast<std::size_t>(file.axis)];
    const QString letter = axisName(file.axis);
    const QVector3D seen = turn.conjugated().rotatedVector(axis.direction);
    const QPointF middle(kSide / 2.0, kSide / 2.0);
    const QPointF offset(static_cast<double>(seen.x()) * kReach, -static_cast<double>(seen.y()) * kReach);
    const auto depth = static_cast<double>(seen.z());
    found.push_back({axis.side, file.same ? letter : QString(), colour, middle + offset, depth});
    found.push_back({axis.far, file.same ? QString() : letter, colour, middle - offset, -depth});
  }
  std::ranges::sort(found, {}, &End::depth);
  return found;
}

std::optional<ViewSide> AxisGizmo::endAt(const QPointF& place) const {
  const std::vector<End> all = ends();
  for (auto end = all.rbegin(); end != all.rend(); ++end) {
    const QPointF away = place - end->place;
    if (QPointF::dotProduct(away, away) <= (kRadius + 2) * (kRadius + 2)) return end->side;
  }
  return std::nullopt;
}

bool AxisGizmo::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const std::optional<ViewSide> end = endAt(help->pos());
    QToolTip::showText(
        help->globalPos(),
        end ? helpOf(*end) : tr("The file's axes (%1). Click one to look along it; drag to turn").arg(units_.upText()),
        this);
    return true;
  }
  return QWidget::event(event);
}

void AxisGizmo::paintEvent(QPaintEvent*) {
  painted_ = camera_.pose().orientation;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = palette().color(QPalette::Base);
  ground.setAlpha(underMouse() ? 235 : 190);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawEllipse(rect().adjusted(1, 1, -1, -1));
  const QPointF middle(kSide / 2.0, kSide / 2.0);
  QFont bold = font();
  bold.setBold(true);
  bold.setPixelSize(12);
  painter.setFont(bold);
  for (const End& end : ends()) {
    const bool near = !end.letter.isEmpty();
    if (near) {
      painter.setPen(QPen(end.colour, 2.5));
      painter.drawLine(middle, end.place);
    }
    const QColor rim = hovered_ == end.side ? palette().color(QPalette::Text) : end.colour;
    painter.setPen(QPen(rim, hovered_ == end.side ? 2.5 : 1.5));
    QColor inside = end.colour;
    if (!near) inside.setAlpha(60);
    painter.setBrush(inside);
    painter.drawEllipse(end.place, near ? kRadius : kRadius - 2.5, near ? kRadius : kRadius - 2.5);
    if (!near) continue;
    painter.setPen(Qt::white);
    painter.drawText(QRectF(end.place.x() - kRadius, end.place.y() - kRadius, 2 * kRadius, 2 * kRadius),
                     Qt::AlignCenter, end.letter);
  }
}

void AxisGizmo::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = last_ = event->pos();
}

void AxisGizmo::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) {
    if (pressed_ && (event->pos() - *pressed_).manhattanLength() < QApplication::startDragDistance()) return;
    pressed_.reset();
    const QPoint way = event->pos() - std::exchange(last_, event->pos());
    camera_.turnBy(-way.x() * kGizmoDegreesPerPixel, way.y() * kGizmoDegreesPerPixel);
    return;
  }
  if (std::exchange(hovered_, endAt(event->position())) != hovered_) update();
}

void AxisGizmo::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !std::exchange(pressed_, std::nullopt)) return;
  if (const std::optional<ViewSide> end = endAt(event->position())) camera_.viewFrom(*end);
}

void AxisGizmo::leaveEvent(QEvent*) {
  hovered_.reset();
  update();
}

}  // namespace footfall::ui
