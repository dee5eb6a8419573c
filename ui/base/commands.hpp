// Everything that can be done from a menu: menus, the tool bar, the list of keys and the command palette follow from
// it.
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
  QString submenu = {};  ///< of its menu, by its title; made for the first one that names it. Empty: the menu itself
};

/// Owns nothing but the order of things: actions belong to the object given to the constructor.
class CommandRegistry : public QObject {
  Q_OBJECT

 public:
  explicit CommandRegistry(QObject* parent);

  /// `menus` are filled as commands come; those that came before are put in at once.
  void setMenu(CommandMenu place, QMenu* menu);
  /// Commands of these groups stand in a submenu of that menu, which exists; to be told before they come. Submenus
  /// stand in the order in which they are made.
  void addSubmenu(CommandMenu place, const QString& title, const QStringList& groups);
  /// `run` gets whether a checkable command is now on; it is called when somebody else checks it, too.
  QAction* add(const Command& command, std::function<void(bool)> run);
  /// An action that exists already (undo, a dock's): takes the keys, the help and the place of `command`, and keeps its
  /// text where that of `command` is empty.
  QAction* registerAction(QAction* action, const Command& command);

  struct Entry {
    Command command;
    QAction* action = nullptr;
  };
  /// In the order in which they were added.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// Null before setMenu().
  [[nodiscard]] QMenu* menu(CommandMenu place) const;
  /// The titles of the menus that lead to a command, the outermost first.
  [[nodiscard]] QStringList path(const Entry& entry) const;
  /// Null when there is none.
  [[nodiscard]] QAction* find(const QString& id) const;

 signals:
  void added(const footfall::ui::CommandRegistry::Entry& entry);

 private:
  void place(const Entry& entry);
  QMenu* submenu(QMenu* menu, const Entry& entry);
  [[nodiscard]] QAction* nextOfGroup(const QMenu* menu, const Entry& entry, bool* grouped) const;

  std::vector<Entry> entries_;
  std::map<CommandMenu, QMenu*> menus_;
  std::map<std::pair<CommandMenu, QString>, QMenu*> groupMenus_;  ///< of groups that have a submenu
};

/// "Open (Ctrl+O)": what a tool tip says of an action.
QString withKeys(const QString& help, const QAction& action);

}  // namespace footfall::ui
