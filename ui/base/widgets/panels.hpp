// The window's panels. Each has a dock, and a command that shows and hides it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QObject>
#include <QString>

#include "ui/base/commands/commands.hpp"

namespace footfall::ui {

/// A dock with one widget, and the command that shows and hides it (in the menu View, group "panels").
struct Panel {
  QString id;     ///< id of the command; the dock's object name
  QString title;  ///< title of the dock and the command
  QString help;
  QList<QKeySequence> keys = {};
  QString icon = {};
  Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
  bool shown = false;   ///< visible at the first start
  QString behind = {};  ///< object name of a dock that shares this one's place and stays in front
};

class Panels : public QObject {
  Q_OBJECT

 public:
  /// `home` gets the focus when a panel that has it is hidden.
  Panels(QMainWindow& window, CommandRegistry& commands, QWidget& home);

  /// Adds a panel. Docks of one area lie one behind the other, beside the list of filters.
  QDockWidget* add(const Panel& panel, QWidget* widget);

  /// Adds a dock without a command, above or below the docks of the area. Users can move it but not close it.
  QDockWidget* addDock(const QString& title, const QString& name, QWidget* widget, Qt::DockWidgetArea area);
  void setHeight(QDockWidget& dock, int height) { window_.resizeDocks({&dock}, {height}, Qt::Vertical); }
  /// Adds the command that shows and hides a dock.
  QAction* addCommand(QDockWidget& dock, const Command& command);

 private:
  void place(QDockWidget* dock, Qt::DockWidgetArea area);

  QMainWindow& window_;
  CommandRegistry& commands_;
  QWidget& home_;
};

}  // namespace footfall::ui
