// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/view_tools.hpp"

#include "ui/base/widgets/panel_dock.hpp"

namespace footfall::ui {

ViewTools::ViewTools(CommandRegistry& commands, LevelView& view, QObject* parent)
    : QObject(parent), commands_(commands), view_(view) {}

QAction* ViewTools::add(Command command, ViewTool* tool, QDockWidget* panel) {
  command.menu = CommandMenu::Tools;
  command.checkable = true;
  auto* action = new QAction(command.text, parent());
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, [this, action, tool, panel](bool on) {
    // A hidden panel is shown by the command, not closed.
    const bool raises = !on && panel && !isInFront(*panel);
    if (on || raises) {
      view_.setTool(tool);
      if (panel) bringToFront(*panel);
      view_.setFocus();
      action->setChecked(true);
    } else {
      view_.setTool(nullptr);
    }
  });
  commands_.registerAction(action, command);
  connect(&view_, &LevelView::toolChanged, action, [this, action, tool] { action->setChecked(view_.tool() == tool); });
  return action;
}

}  // namespace footfall::ui
