// A tool bar that drops the texts of its buttons before it drops buttons.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>

namespace footfall::ui {

/// Shows icons with texts beside them. shareWidth() removes the texts where bars would not fit; buttons that do not fit
/// even then are behind the arrow at the end.
class CommandBar : public QToolBar {
  Q_OBJECT

 public:
  CommandBar(const QString& title, const QString& name, QWidget* parent);

  /// Fits bars that stand in one row of `width`: the last bars lose their texts first. Returns the width that the bars
  /// then need.
  static int shareWidth(const QList<CommandBar*>& bars, int width);

 private:
  int widthWith(Qt::ToolButtonStyle style);
};

}  // namespace footfall::ui
