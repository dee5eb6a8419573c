// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/focus_ring.hpp"

#include <QApplication>
#include <QFocusEvent>
#include <QPainter>
#include <QSplitter>
#include <QStackedWidget>

namespace footfall::ui {
namespace {

constexpr int kWidth = 2;

bool isKeyboardReason(Qt::FocusReason reason) {
  return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
}

class Frame : public QWidget {
 public:
  explicit Frame(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("focusRing"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPen pen(palette().color(QPalette::Link), kWidth);
    pen.setJoinStyle(Qt::RoundJoin);
    painter.setPen(pen);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
  }
};

// The widget that can hold the frame; some containers make every child one of their pages.
QWidget* holderOf(const QWidget* target) {
  QWidget* parent = target->parentWidget();
  while (parent && (qobject_cast<QSplitter*>(parent) || qobject_cast<QStackedWidget*>(parent)))
    parent = parent->parentWidget();
  return parent;
}

}  // namespace

FocusRing::FocusRing(QWidget* window) : QObject(window), window_(window) {
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

bool FocusRing::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::FocusIn:
      if (isKeyboardReason(static_cast<QFocusEvent*>(event)->reason())) {
        byKeyboard_ = true;
        if (watched == QApplication::focusWidget()) follow(QApplication::focusWidget());
      }
      break;
    case QEvent::MouseButtonPress:
      byKeyboard_ = false;
      if (frame_) frame_->hide();
      break;
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Hide:
      if (target_ && watched == target_) place();
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void FocusRing::follow(QWidget* focused) {
  const bool here = focused && focused != window_ && focused->window() == window_;
  target_ = here && byKeyboard_ ? focused : nullptr;
  place();
}

void FocusRing::place() {
  QWidget* holder = target_ && target_->isVisible() ? holderOf(target_) : nullptr;
  if (!holder) {
    if (frame_) frame_->hide();
    return;
  }
  // The frame is a sibling of the target, so that it scrolls and is clipped with it.
  if (frame_ && frame_->parentWidget() != holder) delete frame_;
  if (!frame_) frame_ = new Frame(holder);
  const QRect around(target_->mapTo(holder, QPoint()), target_->size());
  frame_->setGeometry(around.adjusted(-kWidth, -kWidth, kWidth, kWidth).intersected(holder->rect()));
  frame_->raise();
  frame_->show();
}

}  // namespace footfall::ui
