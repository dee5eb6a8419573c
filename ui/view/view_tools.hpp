// The mouse tools of the view, each with its command.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>

#include "ui/base/commands/commands.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

class ViewTools : public QObject {
  Q_OBJECT

 public:
  ViewTools(CommandRegistry& commands, LevelView& view, QObject* parent);

  /// Adds a command of the menu Tools that activates and deactivates `tool`, and is checked while the tool is active.
  /// The tool must outlive the view. With a panel, the command shows it; while the panel is hidden or behind another
  /// tab, the command only brings it to the front.
  QAction* add(Command command, ViewTool* tool, QDockWidget* panel = nullptr);

 private:
  CommandRegistry& commands_;
  LevelView& view_;
};

}  // namespace footfall::ui
