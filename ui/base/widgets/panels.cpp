// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/panels.hpp"

#include "ui/base/widgets/panel_dock.hpp"

namespace footfall::ui {

Panels::Panels(QMainWindow& window, CommandRegistry& commands, QWidget& home)
    : QObject(&window), window_(window), commands_(commands), home_(home) {}

QDockWidget* Panels::add(const Panel& panel, QWidget* widget) {
  QDockWidget* dock = addDock(panel.title, panel.id, widget, panel.area);
  dock->setVisible(panel.shown);
  place(dock, panel.area);
  addCommand(*dock, {panel.id, CommandMenu::View, QStringLiteral("panels"), panel.title, panel.help, panel.keys,
                     panel.icon, true});
  if (auto* front = window_.findChild<QDockWidget*>(panel.behind); front && !panel.behind.isEmpty()) {
    window_.tabifyDockWidget(front, dock);
    front->raise();
  }
  return dock;
}

QDockWidget* Panels::addDock(const QString& title, const QString& name, QWidget* widget, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(name);
  dock->setWidget(new PanelArea(widget, dock));
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  window_.addDockWidget(area, dock);
  return dock;
}

QAction* Panels::addCommand(QDockWidget& dock, const Command& command) {
  dock.setFeatures(dock.features() | QDockWidget::DockWidgetClosable);
  return commands_.registerAction(makePanelAction(dock, home_, &window_), command);
}

// Docks lie one behind the other: each has the whole height, and the tabs show which ones exist.
void Panels::place(QDockWidget* dock, Qt::DockWidgetArea area) {
  for (QDockWidget* other : window_.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const bool list = other->objectName() == QStringLiteral("filterDock");
    if (other == dock || list || other->isFloating() || window_.dockWidgetArea(other) != area) continue;
    window_.tabifyDockWidget(other, dock);
    break;
  }
}

}  // namespace footfall::ui
