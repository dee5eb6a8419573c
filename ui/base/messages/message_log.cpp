// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/messages/message_log.hpp"

#include "ui/base/look/icon.hpp"

namespace footfall::ui {
namespace {

constexpr qint64 kSameWithinMs = 1000;

QString iconName(MessageLevel level) {
  switch (level) {
    case MessageLevel::Error:
      return QStringLiteral("error");
    case MessageLevel::Hint:
      return QStringLiteral("warning");
    case MessageLevel::Note:
      break;
  }
  return QStringLiteral("info");
}

}  // namespace

QString labelOf(MessageLevel level) {
  switch (level) {
    case MessageLevel::Error:
      return MessageLog::tr("error");
    case MessageLevel::Hint:
      return MessageLog::tr("hint");
    case MessageLevel::Note:
      break;
  }
  return MessageLog::tr("note");
}

QString logLine(const LoggedMessage& message) {
  QString text = message.text;
  text.replace(QLatin1Char('\n'), QLatin1String("\n    "));
  return QStringLiteral("%1  %2  %3")
      .arg(message.time.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")), labelOf(message.level), text);
}

MessageLog::MessageLog(QObject* parent) : QAbstractListModel(parent) {}

void MessageLog::add(MessageLevel level, const QString& text) {
  const QDateTime now = QDateTime::currentDateTime();
  if (text.isEmpty()) return;
  if (!messages_.empty() && messages_.back().text == text && messages_.back().level == level &&
      messages_.back().time.msecsTo(now) < kSameWithinMs)
    return;
  if (messages_.size() >= kMost) {
    beginRemoveRows({}, 0, 0);
    messages_.pop_front();
    endRemoveRows();
  }
  const auto row = static_cast<int>(messages_.size());
  beginInsertRows({}, row, row);
  messages_.push_back({now, level, text});
  endInsertRows();
}

void MessageLog::clear() {
  beginResetModel();
  messages_.clear();
  endResetModel();
}

int MessageLog::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(messages_.size());
}

QVariant MessageLog::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (!index.isValid() || row >= messages_.size()) return {};
  const LoggedMessage& message = messages_[row];
  switch (role) {
    case Qt::DisplayRole:
      return QStringLiteral("%1  %2").arg(message.time.toString(QStringLiteral("HH:mm:ss")), message.text);
    case Qt::AccessibleTextRole:
      return QStringLiteral("%1: %2").arg(labelOf(message.level), message.text);
    case Qt::DecorationRole:
      return icon(iconName(message.level));
    case Qt::ToolTipRole:
      return logLine(message);
    case LevelRole:
      return static_cast<int>(message.level);
    case TimeRole:
      return message.time;
    case TextRole:
      return message.text;
    default:
      return {};
  }
}

}  // namespace footfall::ui
