// A tool that has the mouse in the view: asking why, measuring, finding paths, moving obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QPoint>
#include <QString>

namespace footfall::ui {

/// What the mouse did, in the view's logical pixels.
struct ViewMouse {
  QPoint place;
  Qt::MouseButton button = Qt::NoButton;
  Qt::MouseButtons buttons = Qt::NoButton;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

/// LevelView::setTool() gives the mouse to one tool at a time; the camera keeps what the tool does not take. Esc ends a
/// tool that does not take the key itself. Tools pick with LevelView::pick() and draw with LevelView::setOverlay().
class ViewTool {
 public:
  virtual ~ViewTool() = default;
  /// True takes the button until it is released: the camera stays where it is.
  virtual bool mousePressed(const ViewMouse&) { return false; }
  /// With a button that the tool took, or with none.
  virtual void mouseMoved(const ViewMouse&) {}
  virtual void mouseReleased(const ViewMouse&) {}
  /// The left button, pressed and released in one place, not taken by mousePressed().
  virtual void clicked(const ViewMouse&) {}
  /// True: taken.
  virtual bool keyPressed(const QKeyEvent&) { return false; }
  /// The mouse has left the view.
  virtual void mouseLeft() {}
  /// Another tool took over, or Esc; take back what is drawn.
  virtual void ended() {}
  [[nodiscard]] virtual QCursor cursor() const { return Qt::CrossCursor; }
  /// One line for the status bar: what to do next.
  [[nodiscard]] virtual QString hint() const { return {}; }
};

}  // namespace footfall::ui
