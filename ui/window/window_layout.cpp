// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_layout.hpp"

#include <QDockWidget>
#include <QSettings>

namespace footfall::ui {
namespace {

constexpr int kLayoutVersion = 2;  // a new version discards saved docks and tool bars
// Initial widths of docks, in heights of a line.
constexpr int kLeftWidth = 26;
constexpr int kRightWidth = 21;
const auto kGeometryKey = QStringLiteral("windowGeometry");
const auto kStateKey = QStringLiteral("windowState");

}  // namespace

WindowLayout::WindowLayout(QMainWindow& window, ToolBars& bars) : window_(window), bars_(bars) {
  window_.setDockOptions(window_.dockOptions() | QMainWindow::AllowTabbedDocks);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  giveDocksTheirWidth();
  first_ = window_.saveState(kLayoutVersion);
}

void WindowLayout::giveDocksTheirWidth() {
  const int line = window_.fontMetrics().height();
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const Qt::DockWidgetArea area = window_.dockWidgetArea(dock);
    if (area == Qt::LeftDockWidgetArea) window_.resizeDocks({dock}, {kLeftWidth * line}, Qt::Horizontal);
    if (area == Qt::RightDockWidgetArea) window_.resizeDocks({dock}, {kRightWidth * line}, Qt::Horizontal);
  }
}

void WindowLayout::save() const {
  QSettings settings;
  settings.setValue(kGeometryKey, window_.saveGeometry());
  settings.setValue(kStateKey, window_.saveState(kLayoutVersion));
}

void WindowLayout::restore(bool withSize) {
  const QSettings settings;
  if (withSize) window_.restoreGeometry(settings.value(kGeometryKey).toByteArray());
  window_.restoreState(settings.value(kStateKey).toByteArray(), kLayoutVersion);
  bars_.shareWidth();
}

void WindowLayout::reset() {
  window_.restoreState(first_, kLayoutVersion);
  giveDocksTheirWidth();
  bars_.shareWidth();
}

}  // namespace footfall::ui
