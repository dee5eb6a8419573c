// A frame around what has the keyboard, whatever the style draws.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

namespace footfall::ui {

/// Shows once the keyboard has moved the focus (Tab, a mnemonic), and goes when the mouse is used, as in browsers:
/// those who click know where they are. For one window, which owns it; the frame takes no events and no place in
/// layouts.
class FocusRing : public QObject {
  Q_OBJECT

 public:
  explicit FocusRing(QWidget* window);

  /// What it stands around; null while it is hidden.
  [[nodiscard]] QWidget* target() const { return frame_ && frame_->isVisible() ? target_.data() : nullptr; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow(QWidget* focused);
  void place();

  QWidget* window_;
  QPointer<QWidget> target_;
  QPointer<QWidget> frame_;  ///< beside the target: it goes when the target's parent does
  bool byKeyboard_ = false;
};

}  // namespace footfall::ui
