// Takes the look of a control under the mouse back where the mouse has gone without a word.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace footfall::ui {

/// A dialog or a menu that opens over a control takes the mouse away from it, and Qt tells a window that a dialog
/// blocks of no mouse that leaves. Once a window is blocked or free again, or a menu has closed, controls of this
/// window that the mouse is not over are told so.
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
