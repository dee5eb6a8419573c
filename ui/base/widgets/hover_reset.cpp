// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/hover_reset.hpp"

#include <QApplication>
#include <QCursor>
#include <QEvent>
#include <QPointer>
#include <QWidget>

namespace footfall::ui {

HoverReset::HoverReset(QWidget* window) : QObject(window), window_(window) { qApp->installEventFilter(this); }

bool HoverReset::eventFilter(QObject* watched, QEvent* event) {
  const bool blocking = event->type() == QEvent::WindowBlocked || event->type() == QEvent::WindowUnblocked;
  const auto* widget = event->type() == QEvent::Hide ? qobject_cast<QWidget*>(watched) : nullptr;
  const bool closing = widget && widget->windowType() == Qt::Popup;
  // The check runs later, because an opening dialog does not exist yet, and a closing one still has the mouse.
  if ((blocking && watched == window_) || closing)
    QMetaObject::invokeMethod(this, &HoverReset::check, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

void HoverReset::check() {
  const bool blocked = QApplication::activeModalWidget() != nullptr;
  const QWidget* under = blocked ? nullptr : QApplication::widgetAt(QCursor::pos());
  QList<QPointer<QWidget>> left;
  for (QWidget* widget : window_->findChildren<QWidget*>()) {
    const bool still = widget == under || (under && widget->isAncestorOf(under));
    if (widget->underMouse() && !still && !widget->isWindow()) left << widget;
  }
  for (const QPointer<QWidget>& widget : left) {
    QEvent leave(QEvent::Leave);
    if (widget) QCoreApplication::sendEvent(widget, &leave);
    if (widget) widget->update();
  }
}

}  // namespace footfall::ui
