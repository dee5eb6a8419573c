// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/commands.hpp"

#include <algorithm>
#include <utility>

#include "ui/base/look/icon.hpp"

namespace footfall::ui {

CommandRegistry::CommandRegistry(QObject* parent) : QObject(parent) {}

void CommandRegistry::setMenu(CommandMenu menuPlace, QMenu* menu) {
  menus_[menuPlace] = menu;
  menu->setToolTipsVisible(true);
  for (const Entry& entry : entries_) {
    if (entry.command.menu == menuPlace) place(entry);
  }
}

void CommandRegistry::addSubmenu(CommandMenu menuPlace, const QString& title, const QStringList& groups) {
  auto* made = new QMenu(title, menus_.at(menuPlace));
  made->setToolTipsVisible(true);
  const QList<QAction*> there = menus_.at(menuPlace)->actions();
  if (!there.isEmpty() && !there.last()->menu()) menus_.at(menuPlace)->addSeparator();
  menus_.at(menuPlace)->addMenu(made);
  for (const QString& group : groups) groupMenus_[{menuPlace, group}] = made;
}

QAction* CommandRegistry::add(const Command& command, std::function<void(bool)> run) {
  auto* action = new QAction(command.text, parent());
  action->setCheckable(command.checkable);
  if (command.checkable) {
    connect(action, &QAction::toggled, parent(), [run = std::move(run)](bool on) { run(on); });
  } else {
    connect(action, &QAction::triggered, parent(), [run = std::move(run)] { run(true); });
  }
  return registerAction(action, command);
}

QAction* CommandRegistry::registerAction(QAction* action, const Command& command) {
  action->setObjectName(command.id);
  if (!command.text.isEmpty()) action->setText(command.text);
  if (!command.keys.isEmpty()) action->setShortcuts(command.keys);
  if (!command.help.isEmpty()) action->setToolTip(withKeys(command.help, *action));
  action->setStatusTip(command.help);
  if (!command.icon.isEmpty()) action->setIcon(icon(command.icon));
  entries_.push_back({command, action});
  place(entries_.back());
  emit added(entries_.back());
  return action;
}

// Inserts the entry behind the last one of its group, or at the end as a group of its own.
void CommandRegistry::place(const Entry& entry) {
  const auto found = menus_.find(entry.command.menu);
  if (found == menus_.end()) return;
  const auto own = groupMenus_.find({entry.command.menu, entry.command.group});
  QMenu* outer = own == groupMenus_.end() ? found->second : own->second;
  QMenu* menu = entry.command.submenu.isEmpty() ? outer : submenu(outer, entry);
  bool grouped = false;
  QAction* before = nextOfGroup(menu, entry, &grouped);
  if (!grouped && !menu->isEmpty()) menu->addSeparator();
  menu->insertAction(before, entry.action);
}

// The action behind the group of `entry` in `menu`; null when the group is last.
QAction* CommandRegistry::nextOfGroup(const QMenu* menu, const Entry& entry, bool* grouped) const {
  const QList<QAction*> there = menu->actions();
  QAction* next = nullptr;
  for (const Entry& other : entries_) {
    if (other.command.menu != entry.command.menu || other.command.group != entry.command.group) continue;
    QAction* shown = other.action;
    if (!there.contains(shown)) {
      // A group with a submenu stands in the menu as that submenu.
      const auto sub = std::ranges::find_if(there, [&](const QAction* action) {
        return !other.command.submenu.isEmpty() && action->menu() && action->menu()->title() == other.command.submenu;
      });
      if (sub == there.end()) continue;
      shown = *sub;
    }
    const qsizetype at = there.indexOf(shown);
    *grouped = true;
    next = at + 1 < there.size() ? there[at + 1] : nullptr;
  }
  return next;
}

QMenu* CommandRegistry::submenu(QMenu* menu, const Entry& entry) {
  for (const QAction* action : menu->actions()) {
    if (action->menu() && action->menu()->title() == entry.command.submenu) return action->menu();
  }
  bool grouped = false;
  QAction* before = nextOfGroup(menu, entry, &grouped);
  if (!grouped && !menu->isEmpty()) menu->addSeparator();
  auto* made = new QMenu(entry.command.submenu, menu);
  made->setToolTipsVisible(true);
  menu->insertMenu(before, made);
  return made;
}

QMenu* CommandRegistry::menu(CommandMenu menuPlace) const {
  const auto found = menus_.find(menuPlace);
  return found == menus_.end() ? nullptr : found->second;
}

QStringList CommandRegistry::path(const Entry& entry) const {
  QStringList titles;
  if (const QMenu* outer = menu(entry.command.menu)) titles << outer->title();
  const auto inner = groupMenus_.find({entry.command.menu, entry.command.group});
  if (inner != groupMenus_.end()) titles << inner->second->title();
  if (!entry.command.submenu.isEmpty()) titles << entry.command.submenu;
  return titles;
}

QAction* CommandRegistry::find(const QString& id) const {
  const auto found = std::ranges::find(entries_, id, [](const Entry& entry) { return entry.command.id; });
  return found == entries_.end() ? nullptr : found->action;
}

QString withKeys(const QString& help, const QAction& action) {
  if (action.shortcut().isEmpty()) return help;
  return help + QStringLiteral(" (%1)").arg(action.shortcut().toString(QKeySequence::NativeText));
}

}  // namespace footfall::ui
