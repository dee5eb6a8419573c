// The interface of mouse tools in the view: "Why?", measuring, paths, moving obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QPoint>
#include <QString>

namespace footfall::ui {

/// A mouse event, in the view's logical pixels.
struct ViewMouse {
  QPoint place;
  Qt::MouseButton button = Qt::NoButton;
  Qt::MouseButtons buttons = Qt::NoButton;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

/// LevelView::setTool() activates one tool at a time; the camera gets the events that the tool does not handle. Esc
/// ends a tool that does not handle the key itself. Tools pick with LevelView::pick() and draw with
/// LevelView::setOverlay().
class ViewTool {
 public:
  virtual ~ViewTool() = default;
  /// True captures the button until it is released: the camera does not move.
  virtual bool mousePressed(const ViewMouse&) { return false; }
  /// Called with a button that the tool has captured, or with none.
  virtual void mouseMoved(const ViewMouse&) {}
  virtual void mouseReleased(const ViewMouse&) {}
  /// The left button was pressed and released in one place, and mousePressed() has not captured it.
  virtual void clicked(const ViewMouse&) {}
  /// True: handled.
  virtual bool keyPressed(const QKeyEvent&) { return false; }
  /// The mouse has left the view.
  virtual void mouseLeft() {}
  /// Another tool became active, or Esc was pressed; the tool removes its drawing.
  virtual void ended() {}
  [[nodiscard]] virtual QCursor cursor() const { return Qt::CrossCursor; }
  /// One line for the status bar: the next action.
  [[nodiscard]] virtual QString hint() const { return {}; }
};

}  // namespace footfall::ui
