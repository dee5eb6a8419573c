// A line above the view for errors and hints; it blocks nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <array>
#include <functional>

#include "ui/base/message_log.hpp"

namespace footfall::ui {

/// What a message is about: it goes when that is over.
enum class MessageSubject {
  Other,
  Opening,  ///< environments, sessions and pipelines that are read
  Writing,
  Run,
  Keeping,  ///< the session for after a crash
  Filters,  ///< the list, until it changes
  Level,    ///< roles of parts and obstacles
  View,
  Path
};

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  /// Actions are offered as buttons when they have labels.
  void showHint(const QString& text, const QString& label = {}, std::function<void()> action = {},
                const QString& secondLabel = {}, std::function<void()> secondAction = {});
  /// showError() about something that can be over.
  void showErrorOf(MessageSubject subject, const QString& text);
  /// What the message that is shown is about.
  void setSubject(MessageSubject subject) { subject_ = subject; }
  /// Takes the message away if it is about this.
  void finish(MessageSubject subject);
  void clear();
  /// Empty while nothing is shown.
  [[nodiscard]] QString text() const;

 signals:
  void told(footfall::ui::MessageLevel level, const QString& text);

 private:
  struct Choice {
    QPushButton* button = nullptr;
    std::function<void()> action;
  };
  void showText(MessageLevel level, const QString& text);
  void offer(Choice& choice, const QString& label, std::function<void()> action);

  MessageSubject subject_ = MessageSubject::Other;
  QLabel* icon_;
  QLabel* text_;
  std::array<Choice, 2> choices_;
};

}  // namespace footfall::ui
