// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/widgets/height_slider.hpp"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr double kSnap = 6;           // pixels
constexpr double kHandleHeight = 10;  // pixels
constexpr double kStep = 0.01;        // share of the level's height, for an arrow key or a click of the wheel
constexpr double kStorey = 0.8;       // share of the way to the next floor: under its slab, and over heads and doors
constexpr HeightRange kAll;

}  // namespace

HeightSlider::HeightSlider(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("heightSlider"));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::ArrowCursor);
  setAccessibleName(tr("Heights that are shown"));
  setToolTip(
      tr("Hide everything that is higher or lower, to look under roofs. The result does not change.\nHandles snap to "
         "floors, except while Alt is held; a double click shows everything again."));
}

void HeightSlider::setLevel(double lower, double upper, std::vector<double> floors) {
  lower_ = lower;
  upper_ = upper > lower ? upper : lower + 1;
  floors_ = std::move(floors);
  setRange({});
  updateGeometry();
}

void HeightSlider::setUnits(const LevelUnits& units) {
  units_ = units;
  setAccessibleDescription(tr("From %1 to %2").arg(textOf(value(Handle::Lower)), textOf(value(Handle::Upper))));
  updateGeometry();
  update();
}

void HeightSlider::setRange(const HeightRange& range) {
  HeightRange next = range;
  if (next.upper >= upper_ || next.upper < lower_) next.upper = kAll.upper;
  if (next.lower <= lower_ || next.lower > upper_) next.lower = kAll.lower;
  if (next.lower > next.upper) next.lower = next.upper;
  if (next == range_) return;
  range_ = next;
  setAccessibleDescription(tr("From %1 to %2").arg(textOf(value(Handle::Lower)), textOf(value(Handle::Upper))));
  update();
  emit rangeChanged(range_);
}

void HeightSlider::showFloor(int floor) {
  if (floor < 0 || floor >= static_cast<int>(floors_.size())) return;
  const auto i = static_cast<std::size_t>(floor);
  HeightRange storey;
  storey.lower = floors_[i];
  const double next = i + 1 < floors_.size() ? floors_[i + 1] : upper_;
  storey.upper = floors_[i] + kStorey * (next - floors_[i]);
  setRange(storey);
}

std::optional<int> HeightSlider::shownFloor() const {
  if (range_.lower == kAll.lower && range_.upper == kAll.upper) return std::nullopt;
  // The lowest floor may be the bottom of the level, where the handle is at its end.
  for (std::size_t i = 0; i < floors_.size(); ++i) {
    const double next = i + 1 < floors_.size() ? floors_[i + 1] : upper_;
    const double upper = std::min(range_.upper, upper_);
    if (std::max(floors_[i], lower_) == value(Handle::Lower) && upper > floors_[i] && upper <= next)
      return static_cast<int>(i);
  }
  return std::nullopt;
}

double HeightSlider::value(Handle handle) const {
  return handle == Handle::Upper ? std::min(range_.upper, upper_) : std::max(range_.lower, lower_);
}

QString HeightSlider::textOf(double height) const {
  const double span = (upper_ - lower_) * units_.factor();
  constexpr double kLong = 1e7;  // the last digits of longer numbers do not matter
  if (std::max(std::abs(lower_), std::abs(upper_)) * units_.factor() >= kLong)
    return shortText(units_.shownHeight(height), 5);
  const int digits = span >= 1000 ? 0 : span >= 100 ? 1 : 2;
  return fixedText(units_.shownHeight(height), digits);
}

QString HeightSlider::title() const { return tr("Height, %1").arg(units_.name()); }

QSize HeightSlider::sizeHint() const {
  const QFontMetrics metrics(font());
  const int text = std::max({metrics.horizontalAdvance(textOf(lower_)), metrics.horizontalAdvance(textOf(upper_)),
                             metrics.horizontalAdvance(title())});
  return {text + 36, 280};
}

QSize HeightSlider::minimumSizeHint() const { return {sizeHint().width(), 130}; }

QRectF HeightSlider::groove() const {
  const double top = 2 * fontMetrics().height() + 8 + kHandleHeight / 2;
  return {width() - 18.0, top, 4, std::max(10.0, height() - top - fontMetrics().height() - 4)};
}

double HeightSlider::yOf(double height) const {
  const QRectF area = groove();
  return area.bottom() - (height - lower_) / (upper_ - lower_) * area.height();
}

double HeightSlider::heightAt(double y) const {
  const QRectF area = groove();
  return lower_ + (area.bottom() - y) / area.height() * (upper_ - lower_);
}

QPoint HeightSlider::handlePlace(Handle handle) const {
  return QPointF(groove().center().x(), yOf(value(handle))).toPoint();
}

// A handle stops at the other one.
void HeightSlider::moveTo(Handle handle, double height) {
  HeightRange next = range_;
  if (handle == Handle::Upper) {
    next.upper = std::max(height, value(Handle::Lower));
  } else {
    next.lower = std::min(height, value(Handle::Upper));
  }
  setRange(next);
}

void HeightSlider::step(double heights) { moveTo(active_, value(active_) + heights); }

void HeightSlider::stepFloor(int direction) {
  const double now = value(active_);
  const double least = 1e-9 * (upper_ - lower_);
  double target = direction > 0 ? upper_ : lower_;
  for (const double floor : floors_) {
    if (direction > 0 && floor > now + least) target = std::min(target, floor);
    if (direction < 0 && floor < now - least) target = std::max(target, floor);
  }
  moveTo(active_, target);
}

// --- Mouse and keys

void HeightSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const double y = event->position().y();
  const double toUpper = std::abs(y - yOf(value(Handle::Upper)));
  const double toLower = std::abs(y - yOf(value(Handle::Lower)));
  // Where both handles are at the same place, the one that can move in the mouse's direction is taken.
  active_ = toUpper < toLower || (toUpper == toLower && y <= yOf(value(Handle::Upper))) ? Handle::Upper : Handle::Lower;
  dragging_ = true;
  grip_ = std::min(toUpper, toLower) <= kHandleHeight ? y - yOf(value(active_)) : 0;
  if (grip_ == 0) mouseMoveEvent(event);
  update();
}

void HeightSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) return;
  double height = heightAt(event->position().y() - grip_);
  if (!(event->modifiers() & Qt::AltModifier)) {
    const auto distance = [&](double floor) { return std::abs(yOf(floor) - yOf(height)); };
    const auto nearest = std::ranges::min_element(floors_, {}, distance);
    if (nearest != floors_.end() && distance(*nearest) <= kSnap) height = *nearest;
  }
  moveTo(active_, height);
}

void HeightSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) dragging_ = false;
}

void HeightSlider::mouseDoubleClickEvent(QMouseEvent*) {
  dragging_ = false;
  reset();
}

void HeightSlider::wheelEvent(QWheelEvent* event) {
  const double clicks = event->angleDelta().y() / 120.0;
  step(clicks * kStep * (upper_ - lower_));
  event->accept();
}

bool HeightSlider::event(QEvent* event) {
  // The focused slider uses keys that are commands elsewhere.
  if (event->type() == QEvent::ShortcutOverride) {
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Up:
      case Qt::Key_Down:
      case Qt::Key_PageUp:
      case Qt::Key_PageDown:
      case Qt::Key_Home:
      case Qt::Key_End:
        event->accept();
        return true;
      default:
        break;
    }
  }
  return QWidget::event(event);
}

void HeightSlider::keyPressEvent(QKeyEvent* event) {
  const double one = kStep * (upper_ - lower_) * (event->modifiers() & Qt::ShiftModifier ? 10 : 1);
  switch (event->key()) {
    case Qt::Key_Up:
      step(one);
      break;
    case Qt::Key_Down:
      step(-one);
      break;
    case Qt::Key_PageUp:
      stepFloor(1);
      break;
    case Qt::Key_PageDown:
      stepFloor(-1);
      break;
    case Qt::Key_Home:
      moveTo(active_, upper_);
      break;
    case Qt::Key_End:
      moveTo(active_, lower_);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

void HeightSlider::focusInEvent(QFocusEvent* event) {
  if (event->reason() == Qt::TabFocusReason) active_ = Handle::Upper;
  if (event->reason() == Qt::BacktabFocusReason) active_ = Handle::Lower;
  update();
  QWidget::focusInEvent(event);
}

bool HeightSlider::focusNextPrevChild(bool next) {
  const Handle last = next ? Handle::Lower : Handle::Upper;
  if (active_ == last) return QWidget::focusNextPrevChild(next);
  active_ = last;
  update();
  return true;
}

// --- Drawing

void HeightSlider::paintHandle(QPainter& painter, Handle handle) const {
  const double y = yOf(value(handle));
  const QRectF area = groove();
  const bool focused = hasFocus() && handle == active_;
  const QRectF box(area.center().x() - 9, y - kHandleHeight / 2, 18, kHandleHeight);
  painter.setPen(
      QPen(focused ? palette().color(QPalette::Highlight) : palette().color(QPalette::Text), focused ? 2 : 1));
  painter.setBrush(focused ? palette().color(QPalette::Highlight).lighter(150) : palette().color(QPalette::Button));
  painter.drawRoundedRect(box, 3, 3);
  painter.drawLine(QPointF(box.left() + 5, y), QPointF(box.right() - 5, y));
  // Each label is on one side, so that they do not overlap where the handles meet.
  const int line = fontMetrics().height();
  const QRectF text(4, handle == Handle::Upper ? y - line : y, box.left() - 8, line);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, textOf(value(handle)));
}

void HeightSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = palette().color(QPalette::Base);
  ground.setAlpha(225);
  painter.setPen(QPen(palette().color(QPalette::Mid), 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRectF(0, 5, width(), fontMetrics().height()), Qt::AlignHCenter, title());
  const QRectF area = groove();
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Mid));
  painter.drawRoundedRect(area, 2, 2);
  painter.setBrush(palette().color(QPalette::Highlight));
  const double top = yOf(value(Handle::Upper));
  painter.drawRoundedRect(QRectF(area.left(), top, area.width(), yOf(value(Handle::Lower)) - top), 2, 2);
  painter.setPen(QPen(palette().color(QPalette::Text), 1));
  for (const double floor : floors_)
    painter.drawLine(QPointF(area.left() - 8, yOf(floor)), QPointF(area.left() - 3, yOf(floor)));
  paintHandle(painter, Handle::Lower);
  paintHandle(painter, Handle::Upper);
}

}  // namespace footfall::ui
