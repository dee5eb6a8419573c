// Keys of commands that the user has changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>

#include "ui/base/commands/commands.hpp"

namespace footfall::ui {

/// Keeps changed keys in the settings, and sets them on the commands of one window as they are added.
class UserKeys : public QObject {
  Q_OBJECT

 public:
  UserKeys(CommandRegistry& commands, QObject* parent);

  [[nodiscard]] QList<QKeySequence> keysOf(const QString& id) const;
  /// The program's default keys.
  [[nodiscard]] QList<QKeySequence> usualKeysOf(const QString& id) const;
  /// The command other than `id` that has the key; empty where none has it.
  [[nodiscard]] QString ownerOf(const QKeySequence& key, const QString& id) const;
  /// An empty key removes the keys.
  void setKey(const QString& id, const QKeySequence& key);
  void reset(const QString& id);
  void resetAll();

 private:
  void take(const CommandRegistry::Entry& entry);

  CommandRegistry& commands_;
  std::map<QString, QList<QKeySequence>> usual_;
};

}  // namespace footfall::ui
