// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/panel_dock.hpp"

#include <QAbstractItemView>
#include <QApplication>
#include <QLayout>
#include <QScrollBar>
#include <algorithm>

namespace footfall::ui {
namespace {

// The least width of a dock, in heights of a line; narrower docks would show nothing useful.
constexpr int kLeastWidth = 11;
constexpr int kLeastHeight = 6;
// A content that needs more of the window's height scrolls, even if its dock should fit its content.
constexpr double kMostFitted = 0.35;

bool takesFocus(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

}  // namespace

PanelArea::PanelArea(QWidget* content, QWidget* parent) : QScrollArea(parent) {
  setObjectName(QStringLiteral("panelArea"));
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setWidget(content);
}

// Makes the content as large as the area, and no smaller than its minimum. A resizable QScrollArea would give wrapping
// contents their preferred height instead of the height that they need, and lists prefer a lot.
void PanelArea::fit() {
  if (!widget()) return;
  const QSize least = widget()->minimumSizeHint().expandedTo(widget()->minimumSize());
  const QLayout* layout = widget()->layout();
  const auto leastHeight = [&](int width) {
    return layout && layout->hasHeightForWidth() ? layout->totalMinimumHeightForWidth(width) : least.height();
  };
  QSize room = maximumViewportSize();
  int width = std::max(room.width(), least.width());
  if (width > room.width()) room.rheight() -= horizontalScrollBar()->sizeHint().height();
  if (leastHeight(width) > room.height())
    width = std::max(room.width() - verticalScrollBar()->sizeHint().width(), least.width());
  widget()->resize(width, std::max(room.height(), leastHeight(width)));
}

void PanelArea::setFitsContent() {
  fitsContent_ = true;
  window()->installEventFilter(this);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

int PanelArea::contentHeight() const {
  if (!widget()) return 0;
  const int width = std::max(viewport()->width(), widget()->minimumSizeHint().width());
  return widget()->hasHeightForWidth() ? widget()->heightForWidth(width) : widget()->sizeHint().height();
}

// The size that the content prefers; scroll areas would use a part of it.
QSize PanelArea::sizeHint() const {
  if (!widget()) return QScrollArea::sizeHint();
  return fitsContent_ ? QSize(widget()->sizeHint().width(), contentHeight()) : widget()->sizeHint();
}

// The minimum does not depend on the content, because docks grow with it and do not shrink again.
QSize PanelArea::minimumSizeHint() const {
  const int line = fontMetrics().height();
  const int least = kLeastHeight * line;
  if (!fitsContent_) return {kLeastWidth * line, least};
  const int most = std::max(least, static_cast<int>(kMostFitted * window()->height()));
  return {kLeastWidth * line, std::min(contentHeight(), most)};
}

bool PanelArea::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) {
    fit();
    if (fitsContent_) updateGeometry();
  }
  if (watched == window() && event->type() == QEvent::Resize) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

void PanelArea::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
  if (fitsContent_ && event->oldSize().width() != event->size().width()) updateGeometry();
}

// Docks behind a tab count as visible in Qt, but lie beside the window.
bool isInFront(const QDockWidget& dock) {
  return dock.isVisible() && (dock.isWindow() || (dock.geometry().right() >= 0 && dock.geometry().bottom() >= 0));
}

void bringToFront(QDockWidget& dock) {
  dock.show();
  dock.raise();
}

void focusPanel(QDockWidget& dock) {
  QWidget* found = nullptr;
  for (auto* list : dock.findChildren<QAbstractItemView*>()) {
    if (!found && takesFocus(*list)) found = list;
  }
  const QList<QWidget*> all = dock.widget() ? dock.widget()->findChildren<QWidget*>() : QList<QWidget*>();
  const auto first = std::ranges::find_if(all, [](const QWidget* widget) { return takesFocus(*widget); });
  if (!found && first != all.end()) found = *first;
  if (found) found->setFocus(Qt::ShortcutFocusReason);
}

QAction* makePanelAction(QDockWidget& dock, QWidget& home, QObject* parent) {
  auto* action = new QAction(dock.windowTitle(), parent);
  action->setCheckable(true);
  action->setChecked(isInFront(dock));
  QObject::connect(&dock, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
  QObject::connect(action, &QAction::triggered, &dock, [&dock, &home, action] {
    if (isInFront(dock)) {
      const bool hadFocus = dock.isAncestorOf(QApplication::focusWidget());
      dock.close();
      if (hadFocus) home.setFocus();
    } else {
      bringToFront(dock);
      focusPanel(dock);
    }
    action->setChecked(!dock.isHidden());
  });
  return action;
}

}  // namespace footfall::ui
