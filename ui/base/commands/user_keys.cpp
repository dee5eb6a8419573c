// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/user_keys.hpp"

#include <QSettings>

namespace footfall::ui {
namespace {

QString settingOf(const QString& id) { return QStringLiteral("keys/") + id; }

void give(QAction& action, const QList<QKeySequence>& keys, const QString& help) {
  action.setShortcuts(keys);
  if (!help.isEmpty()) action.setToolTip(withKeys(help, action));
}

}  // namespace

UserKeys::UserKeys(CommandRegistry& commands, QObject* parent) : QObject(parent), commands_(commands) {
  for (const CommandRegistry::Entry& entry : commands_.entries()) take(entry);
  connect(&commands_, &CommandRegistry::added, this, &UserKeys::take);
}

void UserKeys::take(const CommandRegistry::Entry& entry) {
  usual_[entry.command.id] = entry.action->shortcuts();
  const QVariant chosen = QSettings().value(settingOf(entry.command.id));
  if (!chosen.isValid()) return;
  const QKeySequence key(chosen.toString(), QKeySequence::PortableText);
  give(*entry.action, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key}, entry.command.help);
}

QList<QKeySequence> UserKeys::keysOf(const QString& id) const {
  const QAction* action = commands_.find(id);
  return action ? action->shortcuts() : QList<QKeySequence>();
}

QList<QKeySequence> UserKeys::usualKeysOf(const QString& id) const {
  const auto found = usual_.find(id);
  return found == usual_.end() ? QList<QKeySequence>() : found->second;
}

QString UserKeys::ownerOf(const QKeySequence& key, const QString& id) const {
  if (key.isEmpty()) return {};
  for (const CommandRegistry::Entry& entry : commands_.entries()) {
    const bool isElsewhere = entry.action->shortcutContext() == Qt::WidgetShortcut;  // the key of a list
    if (entry.command.id != id && !isElsewhere && entry.action->shortcuts().contains(key)) return entry.command.id;
  }
  return {};
}

void UserKeys::setKey(const QString& id, const QKeySequence& key) {
  for (const CommandRegistry::Entry& entry : commands_.entries()) {
    if (entry.command.id != id) continue;
    give(*entry.action, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key}, entry.command.help);
    QSettings().setValue(settingOf(id), key.toString(QKeySequence::PortableText));
  }
}

void UserKeys::reset(const QString& id) {
  for (const CommandRegistry::Entry& entry : commands_.entries())
    if (entry.command.id == id) give(*entry.action, usualKeysOf(id), entry.command.help);
  QSettings().remove(settingOf(id));
}

void UserKeys::resetAll() {
  for (const CommandRegistry::Entry& entry : commands_.entries()) reset(entry.command.id);
}

}  // namespace footfall::ui
