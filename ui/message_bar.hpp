// A line above the view for errors and hints; it blocks nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <array>
#include <functional>

#include "ui/message_log.hpp"

namespace footfall {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  /// Actions are offered as buttons when they have labels.
  void showHint(const QString& text, const QString& label = {}, std::function<void()> action = {},
                const QString& secondLabel = {}, std::function<void()> secondAction = {});
  void clear();
  /// Empty while nothing is shown.
  [[nodiscard]] QString text() const;

 signals:
  void told(footfall::MessageLevel level, const QString& text);

 private:
  struct Choice {
    QPushButton* button = nullptr;
    std::function<void()> action;
  };
  void showText(MessageLevel level, const QString& text);
  void offer(Choice& choice, const QString& label, std::function<void()> action);

  QLabel* icon_;
  QLabel* text_;
  std::array<Choice, 2> choices_;
};

}  // namespace footfall
