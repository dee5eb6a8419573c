// All commands of the menus. The menus, the tool bar, the list of keys and the command palette are made from them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QMenu>
#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace footfall::ui {

enum class CommandMenu { File, Edit, Pipeline, Tools, View, Help };

struct Command {
  QString id;  ///< "view.top"; unique
  CommandMenu menu = CommandMenu::View;
  QString group;  ///< commands of one menu and group stand together, between separators
  QString text;   ///< with an ellipsis where a dialog follows
  QString help;   ///< one sentence; may be empty
  QList<QKeySequence> keys = {};
  QString icon = {};  ///< resources/icons/NAME.svg; may be empty
  bool checkable = false;
  QString submenu = {};  ///< title of a submenu, made for the first command that names it; empty: the menu itself
};

/// The registry owns only the order; actions belong to the object given to the constructor.
class CommandRegistry : public QObject {
  Q_OBJECT

 public:
  explicit CommandRegistry(QObject* parent);

  /// Sets the menu that a place stands for. It is filled as commands are added; earlier commands are inserted at once.
  void setMenu(CommandMenu place, QMenu* menu);
  /// Puts commands of these groups into a submenu of a menu that exists. Called before the commands are added. Submenus
  /// stand in the order in which they are made.
  void addSubmenu(CommandMenu place, const QString& title, const QStringList& groups);
  /// `run` receives whether a checkable command is now on; it is also called when other code checks the command.
  QAction* add(const Command& command, std::function<void(bool)> run);
  /// Registers an existing action (undo, a dock's). It gets the keys, the help and the place of `command`, and keeps
  /// its text where that of `command` is empty.
  QAction* registerAction(QAction* action, const Command& command);

  struct Entry {
    Command command;
    QAction* action = nullptr;
  };
  /// The commands in the order in which they were added.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// The menu of a place; null before setMenu().
  [[nodiscard]] QMenu* menu(CommandMenu place) const;
  /// The titles of the menus that lead to a command, the outermost first.
  [[nodiscard]] QStringList path(const Entry& entry) const;
  /// The action of a command; null when there is none.
  [[nodiscard]] QAction* find(const QString& id) const;

 signals:
  void added(const footfall::ui::CommandRegistry::Entry& entry);

 private:
  void place(const Entry& entry);
  QMenu* submenu(QMenu* menu, const Entry& entry);
  [[nodiscard]] QAction* nextOfGroup(const QMenu* menu, const Entry& entry, bool* grouped) const;

  std::vector<Entry> entries_;
  std::map<CommandMenu, QMenu*> menus_;
  std::map<std::pair<CommandMenu, QString>, QMenu*> groupMenus_;  ///< menus of groups that have a submenu
};

/// The text of an action's tool tip: "Open (Ctrl+O)".
QString withKeys(const QString& help, const QAction& action);

}  // namespace footfall::ui
