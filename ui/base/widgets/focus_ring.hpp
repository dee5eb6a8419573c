// A frame around the focused widget, independent of the style.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

namespace footfall::ui {

/// The frame appears once the keyboard has moved the focus (Tab, a mnemonic), and disappears when the mouse is used, as
/// in browsers. It belongs to one window, which owns it; the frame takes no events and no place in layouts.
class FocusRing : public QObject {
  Q_OBJECT

 public:
  explicit FocusRing(QWidget* window);

  /// The widget that the frame surrounds; null while the frame is hidden.
  [[nodiscard]] QWidget* target() const { return frame_ && frame_->isVisible() ? target_.data() : nullptr; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow(QWidget* focused);
  void place();

  QWidget* window_;
  QPointer<QWidget> target_;
  QPointer<QWidget> frame_;  ///< a sibling of the target, deleted with the target's parent
  bool byKeyboard_ = false;
};

}  // namespace footfall::ui
