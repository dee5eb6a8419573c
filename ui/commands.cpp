// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands.hpp"

#include <algorithm>
#include <utility>

namespace footfall {

CommandRegistry::CommandRegistry(QObject* parent) : QObject(parent) {}

void CommandRegistry::setMenu(CommandMenu menuPlace, QMenu* menu) {
  menus_[menuPlace] = menu;
  menu->setToolTipsVisible(true);
  for (const Entry& entry : entries_) {
    if (entry.command.menu == menuPlace) place(entry);
  }
}

QAction* CommandRegistry::add(const Command& command, std::function<void(bool)> run) {
  auto* action = new QAction(command.text, parent());
  action->setCheckable(command.checkable);
  if (command.checkable) {
    connect(action, &QAction::toggled, parent(), [run = std::move(run)](bool on) { run(on); });
  } else {
    connect(action, &QAction::triggered, parent(), [run = std::move(run)] { run(true); });
  }
  return adopt(action, command);
}

QAction* CommandRegistry::adopt(QAction* action, const Command& command) {
  action->setObjectName(command.id);
  if (!command.text.isEmpty()) action->setText(command.text);
  if (!command.keys.isEmpty()) action->setShortcuts(command.keys);
  if (!command.help.isEmpty()) action->setToolTip(withKeys(command.help, *action));
  action->setStatusTip(command.help);
  entries_.push_back({command, action});
  place(entries_.back());
  emit added(entries_.back());
  return action;
}

// Behind the last one of its group, or at the end as a group of its own.
void CommandRegistry::place(const Entry& entry) {
  const auto found = menus_.find(entry.command.menu);
  if (found == menus_.end()) return;
  QMenu* menu = found->second;
  const QList<QAction*> there = menu->actions();
  QAction* before = nullptr;
  bool grouped = false;
  for (const Entry& other : entries_) {
    if (other.action == entry.action || other.command.menu != entry.command.menu ||
        other.command.group != entry.command.group)
      continue;
    const qsizetype at = there.indexOf(other.action);
    if (at < 0) continue;
    grouped = true;
    before = at + 1 < there.size() ? there[at + 1] : nullptr;
  }
  if (!grouped && !there.isEmpty()) menu->addSeparator();
  menu->insertAction(before, entry.action);
}

QMenu* CommandRegistry::menu(CommandMenu menuPlace) const {
  const auto found = menus_.find(menuPlace);
  return found == menus_.end() ? nullptr : found->second;
}

QAction* CommandRegistry::find(const QString& id) const {
  const auto found = std::ranges::find(entries_, id, [](const Entry& entry) { return entry.command.id; });
  return found == entries_.end() ? nullptr : found->action;
}

QString withKeys(const QString& help, const QAction& action) {
  if (action.shortcut().isEmpty()) return help;
  return help + QStringLiteral(" (%1)").arg(action.shortcut().toString(QKeySequence::NativeText));
}

}  // namespace footfall
