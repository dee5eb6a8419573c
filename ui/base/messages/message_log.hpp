// The messages that the editor has shown since it was started.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QDateTime>
#include <QString>
#include <deque>

namespace footfall::ui {

enum class MessageLevel { Note, Hint, Error };

struct LoggedMessage {
  QDateTime time;
  MessageLevel level = MessageLevel::Note;
  QString text;
};

/// The level as a word for people: "error" and so on.
QString labelOf(MessageLevel level);

/// One row for each message, the oldest first. Keeps the last kMost messages. A message that is repeated within a
/// second is counted and not added.
class MessageLog : public QAbstractListModel {
  Q_OBJECT

 public:
  static constexpr std::size_t kMost = 5000;
  enum Role { LevelRole = Qt::UserRole, TimeRole, TextRole };

  explicit MessageLog(QObject* parent = nullptr);

  void add(MessageLevel level, const QString& text);
  void clear();
  [[nodiscard]] const std::deque<LoggedMessage>& messages() const { return messages_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::deque<LoggedMessage> messages_;
};

/// A line for files and the clipboard: "2026-03-01 14:05:09  error  text"; further lines of the text are indented.
QString logLine(const LoggedMessage& message);

}  // namespace footfall::ui
