// A line above the view for errors and hints; it blocks nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <functional>

namespace footfall {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  /// `action` is offered as a button when it has a label.
  void showHint(const QString& text, const QString& label = {}, std::function<void()> action = {});
  void clear();
  /// Empty while nothing is shown.
  [[nodiscard]] QString text() const;

 private:
  void showText(const QString& kind, const QString& text, const QString& label, std::function<void()> action);

  QLabel* text_;
  QPushButton* button_;
  std::function<void()> action_;
};

}  // namespace footfall
