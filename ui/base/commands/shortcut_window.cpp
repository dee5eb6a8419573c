// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/shortcut_window.hpp"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>
#include <array>
#include <utility>
#include <vector>

#include "ui/base/commands/command_palette.hpp"
#include "ui/base/commands/commands.hpp"

namespace footfall::ui {
namespace {

std::vector<std::pair<QString, QString>> mouseRows() {
  return {
      {ShortcutWindow::tr("Left drag"), ShortcutWindow::tr("Turn about the pivot")},
      {ShortcutWindow::tr("Right or middle drag, Shift+left drag"), ShortcutWindow::tr("Move sideways")},
      {ShortcutWindow::tr("Wheel, Ctrl+left drag"), ShortcutWindow::tr("Zoom")},
      {ShortcutWindow::tr("Double click"), ShortcutWindow::tr("Turn about this place from now on")},
      {ShortcutWindow::tr("Click on a cell"), ShortcutWindow::tr("Select it and bring it into sight")},
      {ShortcutWindow::tr("Arrow keys"), ShortcutWindow::tr("Move sideways (in the view)")},
      {ShortcutWindow::tr("Alt+Up, Alt+Down"), ShortcutWindow::tr("Move a filter in the list")},
      {ShortcutWindow::tr("Up, Down"), ShortcutWindow::tr("Change the value of a field by a small step")},
      {ShortcutWindow::tr("Tab, Shift+Tab"), ShortcutWindow::tr("Next and previous control")},
      {ShortcutWindow::tr("F10, Alt"), ShortcutWindow::tr("The menus")},
      {ShortcutWindow::tr("Esc"), ShortcutWindow::tr("End a tool, cancel a run, restore a field's value")},
  };
}

QTreeWidgetItem* addGroup(QTreeWidget* table, const QString& title) {
  auto* group = new QTreeWidgetItem(table, {title});
  QFont bold = table->font();
  bold.setBold(true);
  group->setFont(0, bold);
  group->setFirstColumnSpanned(true);
  group->setFlags(Qt::ItemIsEnabled);
  group->setExpanded(true);
  return group;
}

}  // namespace

ShortcutWindow::ShortcutWindow(const CommandRegistry& commands, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("shortcutWindow"));
  setWindowTitle(tr("Keys and mouse"));
  search_ = new QLineEdit(this);
  search_->setObjectName(QStringLiteral("shortcutSearch"));
  search_->setPlaceholderText(tr("Search for a command or a key"));
  search_->setAccessibleName(tr("Search for a command or a key"));
  search_->setToolTip(tr("Show rows with this text"));
  search_->setClearButtonEnabled(true);
  table_ = new QTreeWidget(this);
  table_->setObjectName(QStringLiteral("shortcutTable"));
  table_->setAccessibleName(tr("Keys and mouse"));
  table_->setColumnCount(3);
  table_->setHeaderLabels({tr("Command"), tr("Keys"), tr("What it does")});
  table_->setRootIsDecorated(false);
  table_->setAlternatingRowColors(true);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setIndentation(12);
  fill(commands);
  for (int column = 0; column < 2; ++column) table_->resizeColumnToContents(column);
  table_->header()->setStretchLastSection(true);
  table_->setTextElideMode(Qt::ElideRight);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(search_);
  layout->addWidget(table_, 1);
  layout->addWidget(buttons);
  connect(search_, &QLineEdit::textChanged, this, &ShortcutWindow::filter);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(std::min(860, parent->width() - 60), std::min(640, parent->height() - 60));
  // Descriptions of commands are the longest texts, and are read most.
  for (const auto& [column, share] : {std::pair{0, 0.36}, std::pair{1, 0.24}})
    table_->setColumnWidth(column, std::min(table_->columnWidth(column), static_cast<int>(share * width())));
  search_->setFocus();
}

void ShortcutWindow::fill(const CommandRegistry& commands) {
  constexpr std::array kMenus = {CommandMenu::File,  CommandMenu::Edit, CommandMenu::Pipeline,
                                 CommandMenu::Tools, CommandMenu::View, CommandMenu::Help};
  for (const bool withKeys : {true, false}) {
    for (const CommandMenu place : kMenus) {
      QTreeWidgetItem* group = nullptr;
      for (const CommandRegistry::Entry& entry : commands.entries()) {
        if (entry.command.menu != place || entry.action->menu()) continue;
        QStringList keys;
        for (const QKeySequence& key : entry.action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
        if (keys.isEmpty() == withKeys) continue;
        const QString title = commands.menu(place) ? plainText(commands.menu(place)->title()) : QString();
        if (!group) group = addGroup(table_, withKeys ? title : tr("%1, without keys").arg(title));
        auto* row = new QTreeWidgetItem(
            group, {plainText(entry.action->text()), keys.join(QStringLiteral(", ")), entry.command.help});
        for (int column = 0; column < 3; ++column) row->setToolTip(column, row->text(column));
      }
    }
    if (!withKeys) break;
    QTreeWidgetItem* mouse = addGroup(table_, tr("Mouse, view and fields"));
    for (const auto& [keys, what] : mouseRows()) {
      auto* row = new QTreeWidgetItem(mouse, {what, keys, QString()});
      for (int column = 0; column < 2; ++column) row->setToolTip(column, row->text(column));
    }
  }
}

void ShortcutWindow::filter(const QString& text) {
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = table_->topLevelItem(i);
    bool any = false;
    for (int j = 0; j < group->childCount(); ++j) {
      QTreeWidgetItem* row = group->child(j);
      bool found = false;
      for (int column = 0; column < 3; ++column) found = found || row->text(column).contains(text, Qt::CaseInsensitive);
      row->setHidden(!found);
      any = any || found;
    }
    group->setHidden(!any);
  }
}

}  // namespace footfall::ui
