// Removes the hover effect of a control when the mouse has left it without an event.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace footfall::ui {

/// A dialog or a menu that opens over a control takes the mouse from it, and Qt sends no leave event to a window that a
/// dialog blocks. Once a window is blocked or free again, or a menu has closed, this object sends leave events to
/// controls of the window that the mouse is not over.
class HoverReset : public QObject {
  Q_OBJECT

 public:
  explicit HoverReset(QWidget* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void check();

  QWidget* window_;
};

}  // namespace footfall::ui
