// FilterList: handling of mouse and keyboard.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QApplication>
#include <QContextMenuEvent>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QStyle>
#include <algorithm>
#include <utility>

#include "ui/filters/filter_list.hpp"

namespace footfall::ui {

bool FilterList::event(QEvent* event) {
  // Handles keys that no row has handled: paste and select all also work in an empty list.
  if ((event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) && !typing()) {
    if (actions_->handleKey(*static_cast<QKeyEvent*>(event), event->type() == QEvent::KeyPress)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

// Keys that a field does not use have no other effect.
bool FilterList::typing() const { return qobject_cast<const QLineEdit*>(focusWidget()) && rowOf(focusWidget()); }

bool FilterList::eventFilter(QObject* watched, QEvent* event) {
  FilterRow* row = rowOf(watched);
  if (!row) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      if (handlePress(row, watched, *static_cast<QMouseEvent*>(event))) return true;
      break;
    case QEvent::MouseMove:
      if (handleMove(*static_cast<QMouseEvent*>(event))) return true;
      break;
    case QEvent::MouseButtonRelease:
      if (handleRelease()) return true;
      break;
    case QEvent::FocusIn:
      if (choosing_ || selection_.current() == row->entryId()) break;
      // The press that gave the focus follows, and has Shift and Ctrl.
      if (watched == row && static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason) break;
      selection_.choose(row->entryId());
      showSelection();
      break;
    case QEvent::ContextMenu: {
      if (watched != row) break;
      QMenu* menu = actions_->makeMenu(this);
      menu->setAttribute(Qt::WA_DeleteOnClose);
      menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
      return true;
    }
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      if (!handleKey(row, watched, *static_cast<QKeyEvent*>(event), event->type() == QEvent::KeyPress)) break;
      event->accept();
      return true;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

// Labels pass presses on to the row; buttons and fields handle them.
bool FilterList::handlePress(FilterRow* row, const QObject* watched, const QMouseEvent& event) {
  const bool onHandle = watched == row->handle();
  if (watched != row && !onHandle) return false;
  const bool chosen = selection_.contains(row->entryId());
  // A press on a selected row keeps the selection, for a drag or a menu.
  const bool plain = event.modifiers() == Qt::NoModifier;
  const bool keeps = chosen && plain;
  pressed_ = event.button() == Qt::LeftButton && plain ? row : nullptr;
  pressedAt_ = event.globalPosition().toPoint();
  keepsSelection_ = keeps;
  if (!keeps && (event.button() == Qt::LeftButton || !chosen)) {
    selection_.choose(row->entryId(), event.button() == Qt::LeftButton ? event.modifiers() : Qt::NoModifier);
    showSelection();
  }
  choosing_ = true;
  row->setFocus(Qt::MouseFocusReason);
  choosing_ = false;
  return pressed_ != nullptr;
}

bool FilterList::handleMove(const QMouseEvent& event) {
  if (!pressed_) return false;
  const QPoint at = event.globalPosition().toPoint();
  if (!dragged_ && (at - pressedAt_).manhattanLength() < QApplication::startDragDistance()) return true;
  if (!dragged_) beginDrag(pressed_);
  moveDrag(at);
  return true;
}

// A press on one of several selected rows selects it when no drag follows.
bool FilterList::handleRelease() {
  FilterRow* row = std::exchange(pressed_, nullptr);
  if (!row) return false;
  if (dragged_) {
    endDrag(true);
    openCurrent();
    return true;
  }
  if (keepsSelection_) selection_.choose(row->entryId());
  showSelection();
  return true;
}

bool FilterList::handleKey(FilterRow* row, const QObject* watched, QKeyEvent& key, bool perform) {
  if (dragged_ && key.key() == Qt::Key_Escape) {
    if (perform) {
      endDrag(false);
      pressed_ = nullptr;
    }
    return true;
  }
  const bool arrow = key.key() == Qt::Key_Up || key.key() == Qt::Key_Down;
  if (arrow && key.modifiers() == Qt::AltModifier) {
    if (!selection_.contains(row->entryId())) choose({row->entryId()});
    return actions_->handleKey(key, perform);
  }
  const bool plain = key.modifiers() == Qt::NoModifier || key.modifiers() == Qt::KeypadModifier;
  const bool enter = plain && (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter);
  if (typing() || qobject_cast<const QLineEdit*>(watched)) {
    return enter && !perform;  // the field handles these keys, and no shortcut uses them
  }
  if (key.key() == Qt::Key_Space && watched != row) return false;  // the button handles the space key
  if (enter && watched == row) {
    // Focuses the first field.
    for (QLineEdit* field : row->findChildren<QLineEdit*>()) {
      if (perform && field->isEnabled()) {
        field->setFocus(Qt::TabFocusReason);
        break;
      }
    }
    return true;
  }
  const bool extend = key.modifiers() == Qt::ShiftModifier;
  if (extend || key.modifiers() == Qt::NoModifier) {
    const int rows = static_cast<int>(rows_.size());
    const int step = key.key() == Qt::Key_Up     ? -1
                     : key.key() == Qt::Key_Down ? 1
                     : key.key() == Qt::Key_Home ? -rows
                     : key.key() == Qt::Key_End  ? rows
                                                 : 0;
    if (step != 0) {
      if (!perform) return true;
      selection_.step(step, extend);
      showSelection();
      focusCurrent();
      return true;
    }
  }
  return actions_->handleKey(key, perform);
}

void FilterList::choose(const FilterIds& ids) {
  selection_.choose(ids);
  showSelection();
  focusCurrent();
}

void FilterList::focusCurrent() {
  FilterRow* row = rowOf(selection_.current());
  if (!row) return;
  choosing_ = true;
  row->setFocus(Qt::TabFocusReason);
  choosing_ = false;
  // The scroll happens later, because a new row has no place yet.
  const int id = row->entryId();
  QMetaObject::invokeMethod(
      this,
      [this, id] {
        if (FilterRow* there = rowOf(id)) scroll_->ensureWidgetVisible(there, 0, 8);
      },
      Qt::QueuedConnection);
}

void FilterList::beginDrag(FilterRow* row) {
  dragged_ = row;
  dropGap_ = static_cast<std::size_t>(std::find(rows_.begin(), rows_.end(), row) - rows_.begin());
  row->handle()->setCursor(Qt::ClosedHandCursor);
  row->setProperty("dragged", true);
  row->style()->unpolish(row);
  row->style()->polish(row);
}

std::size_t FilterList::gapAt(int y) const {
  std::size_t gap = 0;
  while (gap < rows_.size() && y > rows_[gap]->geometry().center().y()) ++gap;
  return gap;
}

void FilterList::moveDrag(const QPoint& globalPosition) {
  const QPoint inScroll = scroll_->viewport()->mapFromGlobal(globalPosition);
  QScrollBar* bar = scroll_->verticalScrollBar();
  if (inScroll.y() < 16) bar->setValue(bar->value() - 12);
  if (inScroll.y() > scroll_->viewport()->height() - 16) bar->setValue(bar->value() + 12);

  dropGap_ = gapAt(content_->mapFromGlobal(globalPosition).y());
  const int y = dropGap_ < rows_.size() ? rows_[dropGap_]->geometry().top() - 4 : rows_.back()->geometry().bottom() + 2;
  dropLine_->setGeometry(0, std::max(0, y), content_->width(), 3);
  dropLine_->raise();
  dropLine_->show();
}

void FilterList::endDrag(bool drop) {
  FilterRow* row = dragged_;
  dragged_ = nullptr;
  dropLine_->hide();
  row->handle()->setCursor(Qt::OpenHandCursor);
  row->setProperty("dragged", false);
  row->style()->unpolish(row);
  row->style()->polish(row);
  if (drop) moveFiltersTo(document_, selection_.ids(), dropGap_);
}

}  // namespace footfall::ui
