// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/fly_tool.hpp"

#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

namespace footfall::ui {
namespace {

constexpr double kDegreesPerPixel = 0.2;
constexpr double kFaster = 4;
constexpr double kWheelFactor = 1.25;
constexpr double kLongestStep = 0.25;  // in seconds: a slow frame must not move the camera far
constexpr std::array kKeys = {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};

bool isFlyKey(int key) { return std::ranges::find(kKeys, key) != kKeys.end(); }

}  // namespace

FlyTool::FlyTool(LevelView& view, QObject* parent) : QObject(parent), view_(view), camera_(view.cameraController()) {
  timer_.setInterval(15);
  connect(&timer_, &QTimer::timeout, this, &FlyTool::step);
  connect(&view_, &LevelView::toolChanged, this, [this] {
    if (view_.tool() == this) begin();
  });
}

QString FlyTool::hint() const {
  return tr("Fly: W A S D move, Q and E down and up, the mouse looks, Shift faster, the wheel changes the speed (%1 "
            "units a second), Esc ends")
      .arg(speed_, 0, 'g', 3);
}

void FlyTool::begin() {
  if (flying_) return;
  flying_ = true;
  if (camera_.orthographic()) camera_.setOrthographic(false);
  view_.installEventFilter(this);
  view_.setFocus();
  last_.reset();
}

void FlyTool::ended() {
  flying_ = false;
  view_.removeEventFilter(this);
  timer_.stop();
  held_.clear();
  fast_ = false;
}

void FlyTool::look(const QPoint& place) {
  if (last_) {
    const QPoint way = place - *last_;
    camera_.lookBy(way.x() * kDegreesPerPixel, -way.y() * kDegreesPerPixel);
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

void FlyTool::step() {
  const double seconds = std::min(static_cast<double>(sinceStep_.nsecsElapsed()) * 1e-9, kLongestStep);
  sinceStep_.restart();
  const auto sign = [this](int plus, int minus) {
    return static_cast<double>(held_.contains(plus)) - static_cast<double>(held_.contains(minus));
  };
  const double way = seconds * speed_ * (fast_ ? kFaster : 1);
  camera_.walkBy(way * sign(Qt::Key_D, Qt::Key_A), way * sign(Qt::Key_E, Qt::Key_Q), way * sign(Qt::Key_W, Qt::Key_S));
}

bool FlyTool::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::ShortcutOverride:
      // These letters are commands elsewhere.
      if (!isFlyKey(static_cast<QKeyEvent*>(event)->key())) return false;
      event->accept();
      return true;
    case QEvent::KeyPress:
    case QEvent::KeyRelease: {
      const auto* key = static_cast<QKeyEvent*>(event);
      const bool down = event->type() == QEvent::KeyPress;
      fast_ = key->key() == Qt::Key_Shift ? down : key->modifiers().testFlag(Qt::ShiftModifier);
      if (!isFlyKey(key->key())) return false;
      if (key->isAutoRepeat()) return true;
      if (down) {
        held_.insert(key->key());
      } else {
        held_.erase(key->key());
      }
      if (held_.empty()) {
        timer_.stop();
      } else if (!timer_.isActive()) {
        sinceStep_.start();
        timer_.start();
      }
      return true;
    }
    case QEvent::Wheel:
      speed_ *= std::pow(kWheelFactor, static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0);
      emit speedChanged(speed_);
      return true;
    case QEvent::MouseMove:
      look(static_cast<QMouseEvent*>(event)->position().toPoint());
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
      return true;  // the mouse is hidden, so that nothing can be clicked
    case QEvent::FocusOut:
      held_.clear();  // releases of these keys are not received any more
      timer_.stop();
      return false;
    case QEvent::Leave:
      last_.reset();
      return false;
    default:
      return false;
  }
}

}  // namespace footfall::ui
