// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/steering/steering_input.hpp"

#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

namespace footfall::ui {
namespace {

constexpr double kDegreesPerPixel = 0.2;
constexpr double kLongestStep = 0.25;  // seconds: after a frame that took long, nobody wants to be elsewhere

}  // namespace

SteeringInput::SteeringInput(LevelView& view, std::set<int> keys, QObject* parent)
    : QObject(parent), view_(view), keys_(std::move(keys)) {
  timer_.setInterval(15);
  connect(&timer_, &QTimer::timeout, this, &SteeringInput::step);
}

void SteeringInput::begin() {
  if (std::exchange(active_, true)) return;
  view_.installEventFilter(this);
  view_.setFocus();
  last_.reset();
  updateTimer();
}

void SteeringInput::end() {
  active_ = fast_ = false;
  view_.removeEventFilter(this);
  held_.clear();
  updateTimer();
}

void SteeringInput::setAlwaysAdvancing(bool on) {
  always_ = on;
  updateTimer();
}

void SteeringInput::updateTimer() {
  const bool wanted = active_ && (always_ || !held_.empty());
  if (wanted == timer_.isActive()) return;
  if (wanted) {
    sinceStep_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
}

void SteeringInput::look(const QPoint& place) {
  if (last_) {
    const QPoint way = place - *last_;
    emit looked(way.x() * kDegreesPerPixel, -way.y() * kDegreesPerPixel);
  }
  last_ = place;
  // The mouse is moved back before it leaves the view. Where the system does not allow this, the camera turns until the
  // mouse has left.
  const QRect inner =
      view_.rect().adjusted(view_.width() / 8, view_.height() / 8, -view_.width() / 8, -view_.height() / 8);
  if (inner.contains(place) || !view_.isActiveWindow()) return;
  QCursor::setPos(view_.mapToGlobal(view_.rect().center()));
  last_.reset();  // the next place is the one that it was moved to
}

void SteeringInput::step() {
  const double seconds = std::min(static_cast<double>(sinceStep_.nsecsElapsed()) * 1e-9, kLongestStep);
  sinceStep_.restart();
  emit advanced(seconds);
}

bool SteeringInput::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::ShortcutOverride:
      // Letters are commands elsewhere.
      if (!keys_.contains(static_cast<QKeyEvent*>(event)->key())) return false;
      event->accept();
      return true;
    case QEvent::KeyPress:
    case QEvent::KeyRelease: {
      const auto* key = static_cast<QKeyEvent*>(event);
      const bool down = event->type() == QEvent::KeyPress;
      fast_ = key->key() == Qt::Key_Shift ? down : key->modifiers().testFlag(Qt::ShiftModifier);
      if (!keys_.contains(key->key())) return false;
      if (key->isAutoRepeat()) return true;
      if (down) {
        held_.insert(key->key());
      } else {
        held_.erase(key->key());
      }
      updateTimer();
      return true;
    }
    case QEvent::Wheel:
      emit wheelTurned(static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0);
      return true;
    case QEvent::MouseMove:
      look(static_cast<QMouseEvent*>(event)->position().toPoint());
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
      return true;  // the mouse is hidden, so that nothing can be clicked
    case QEvent::FocusOut:
      held_.clear();  // the release of a key is sent elsewhere now
      updateTimer();
      return false;
    case QEvent::Leave:
      last_.reset();
      return false;
    default:
      return false;
  }
}

}  // namespace footfall::ui
