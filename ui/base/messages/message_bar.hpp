// A line above the view for errors and hints that block nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <array>
#include <functional>

#include "ui/base/messages/message_log.hpp"

namespace footfall::ui {

/// The subject of a message; the message disappears when the subject is over.
enum class MessageSubject {
  Other,
  Opening,  ///< reading environments, sessions and pipelines
  Writing,
  Run,
  Keeping,  ///< writing the session for recovery after a crash
  Filters,  ///< the list of filters, until it changes
  Level,    ///< roles of parts, and obstacles
  View,
  Path
};

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  /// Actions with a label are offered as buttons.
  void showHint(const QString& text, const QString& label = {}, std::function<void()> action = {},
                const QString& secondLabel = {}, std::function<void()> secondAction = {});
  /// Shows an error that disappears when its subject is over.
  void showErrorOf(MessageSubject subject, const QString& text);
  /// Sets the subject of the shown message.
  void setSubject(MessageSubject subject) { subject_ = subject; }
  /// Removes the message if it has this subject.
  void finish(MessageSubject subject);
  void clear();
  /// The shown text; empty while nothing is shown.
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
