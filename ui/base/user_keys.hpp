// Keys of commands that the user has changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>

#include "ui/base/commands.hpp"

namespace footfall::ui {

/// Kept in the settings, and given to the commands of one window as they come.
class UserKeys : public QObject {
  Q_OBJECT

 public:
  UserKeys(CommandRegistry& commands, QObject* parent);

  [[nodiscard]] QList<QKeySequence> keysOf(const QString& id) const;
  /// The keys that the program gives.
  [[nodiscard]] QList<QKeySequence> usualKeysOf(const QString& id) const;
  /// The command that has the key, but for `id`; empty where none has.
  [[nodiscard]] QString ownerOf(const QKeySequence& key, const QString& id) const;
  /// An empty one takes the keys away.
  void setKey(const QString& id, const QKeySequence& key);
  void reset(const QString& id);
  void resetAll();

 private:
  void take(const CommandRegistry::Entry& entry);

  CommandRegistry& commands_;
  std::map<QString, QList<QKeySequence>> usual_;
};

}  // namespace footfall::ui
