// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/tool_bars.hpp"

namespace footfall::ui {

ToolBars::ToolBars(QMainWindow& window, CommandRegistry& commands)
    : QObject(&window),
      window_(window),
      commands_(commands),
      main_(new CommandBar(tr("Files and view"), QStringLiteral("toolBar"), &window)),
      tools_(new CommandBar(tr("Tools"), QStringLiteral("toolsBar"), &window)) {
  tools_->hide();
  for (CommandBar* bar : {main_, tools_}) {
    window_.addToolBar(bar);
    connect(bar->toggleViewAction(), &QAction::toggled, this, &ToolBars::shareWidth);
  }
  connect(&commands_, &CommandRegistry::added, this, &ToolBars::addTool);
}

void ToolBars::add(QAction* action, const QString& text) {
  action->setIconText(text);
  main_->addAction(action);
}

// Adds tools with icons, group by group, in the order in which they are registered.
void ToolBars::addTool(const CommandRegistry::Entry& entry) {
  if (entry.command.menu != CommandMenu::Tools || entry.command.icon.isEmpty()) return;
  QAction* before = nullptr;
  bool grouped = false;
  const QList<QAction*> there = tools_->actions();
  for (const CommandRegistry::Entry& other : commands_.entries()) {
    if (other.command.menu != entry.command.menu || other.command.group != entry.command.group) continue;
    const qsizetype at = there.indexOf(other.action);
    if (at < 0) continue;
    grouped = true;
    before = at + 1 < there.size() ? there[at + 1] : nullptr;
  }
  if (!grouped && !there.isEmpty()) tools_->addSeparator();
  tools_->insertAction(before, entry.action);
  tools_->show();
  shareWidth();
}

// Where even the icons have no room in one row, the tools get a row of their own, so that all of them are visible.
void ToolBars::shareWidth() {
  const bool breaks = CommandBar::shareWidth({main_, tools_}, window_.width()) > window_.width();
  if (breaks != window_.toolBarBreak(tools_)) {
    if (breaks)
      window_.insertToolBarBreak(tools_);
    else
      window_.removeToolBarBreak(tools_);
  }
  if (!breaks) return;
  for (CommandBar* bar : {main_, tools_}) CommandBar::shareWidth({bar}, window_.width());
}

}  // namespace footfall::ui
