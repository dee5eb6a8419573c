// The window's two tool bars.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QObject>

#include "ui/base/commands/command_bar.hpp"
#include "ui/base/commands/commands.hpp"

namespace footfall::ui {

/// One bar has the commands for files and the view; the other has those of the menu Tools, and is filled as they are
/// registered.
class ToolBars : public QObject {
  Q_OBJECT

 public:
  ToolBars(QMainWindow& window, CommandRegistry& commands);

  [[nodiscard]] CommandBar& main() { return *main_; }
  /// Adds an action to the main bar; `text` is shorter than in the menu.
  void add(QAction* action, const QString& text);
  /// Puts both bars in one row where they fit; a bar that does not fit shows icons only. Called when the window's width
  /// has changed.
  void shareWidth();

 private:
  void addTool(const CommandRegistry::Entry& entry);

  QMainWindow& window_;
  CommandRegistry& commands_;
  CommandBar* main_;
  CommandBar* tools_;
};

}  // namespace footfall::ui
