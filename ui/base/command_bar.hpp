// A tool bar whose texts go before its buttons do.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>

namespace footfall::ui {

/// Icons with texts beside them. shareWidth() takes the texts away where bars would not fit; what does not fit even so
/// is behind the arrow at the end.
class CommandBar : public QToolBar {
  Q_OBJECT

 public:
  CommandBar(const QString& title, const QString& name, QWidget* parent);

  /// Bars that stand in one row of `width`: the last ones lose their texts first. Returns the width that they need even
  /// so.
  static int shareWidth(const QList<CommandBar*>& bars, int width);

 private:
  int widthWith(Qt::ToolButtonStyle style);
};

}  // namespace footfall::ui
