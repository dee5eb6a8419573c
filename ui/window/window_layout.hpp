// Where docks and tool bars are, and how large the window is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMainWindow>

#include "ui/window/tool_bars.hpp"

namespace footfall::ui {

class WindowLayout {
 public:
  /// The docks and bars that the window has by now are the layout at first, which reset() goes back to.
  WindowLayout(QMainWindow& window, ToolBars& bars);

  /// In the user's settings.
  void save() const;
  void restore(bool withSize);
  void reset();

 private:
  void giveDocksTheirWidth();

  QMainWindow& window_;
  ToolBars& bars_;
  QByteArray first_;
};

}  // namespace footfall::ui
