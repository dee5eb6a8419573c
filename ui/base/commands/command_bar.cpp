// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/command_bar.hpp"

#include <QLayout>
#include <QToolButton>

namespace footfall::ui {

CommandBar::CommandBar(const QString& title, const QString& name, QWidget* parent) : QToolBar(title, parent) {
  setObjectName(name);
  setMovable(false);
  setIconSize(QSize(20, 20));
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

int CommandBar::widthWith(Qt::ToolButtonStyle style) {
  if (toolButtonStyle() != style) setToolButtonStyle(style);
  // A button with an icon only needs its tool tip; a text without an icon stays a text.
  for (auto* button : findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (button->icon().isNull() && !button->text().isEmpty()) button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  }
  layout()->invalidate();
  return layout()->sizeHint().width();
}

int CommandBar::shareWidth(const QList<CommandBar*>& bars, int width) {
  QList<int> wide, narrow;
  for (CommandBar* bar : bars) {
    narrow << (bar->isHidden() ? 0 : bar->widthWith(Qt::ToolButtonIconOnly));
    wide << (bar->isHidden() ? 0 : bar->widthWith(Qt::ToolButtonTextBesideIcon));
  }
  int needed = 0;
  for (const int one : wide) needed += one;
  for (qsizetype i = bars.size() - 1; i >= 0 && needed > width; --i) {
    bars[i]->widthWith(Qt::ToolButtonIconOnly);
    needed += narrow[i] - wide[i];
  }
  return needed;
}

}  // namespace footfall::ui
