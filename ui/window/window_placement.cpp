// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_placement.hpp"

#include <QScreen>
#include <QWidget>

namespace footfall::ui {

QRect firstGeometry(const QRect& available, const QMargins& frame, const QSize& wanted) {
  const QRect inner = available.marginsRemoved(frame);
  QRect place(QPoint(), wanted.boundedTo(inner.size()));
  place.moveCenter(inner.center());
  return place;
}

void placeAtFirst(QWidget& window, const QSize& wanted) {
  const QScreen* screen = window.screen();
  if (!screen) return window.resize(wanted);
  // The frame is known only after the window has been shown, which is too late; title bars are up to three lines of
  // text high.
  const int line = window.fontMetrics().height();
  window.setGeometry(firstGeometry(screen->availableGeometry(), {line / 2, 3 * line, line / 2, line / 2}, wanted));
}

}  // namespace footfall::ui
