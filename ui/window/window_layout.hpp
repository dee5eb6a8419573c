// The places of docks and tool bars, and the size of the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMainWindow>

#include "ui/window/tool_bars.hpp"

namespace footfall::ui {

class WindowLayout {
 public:
  /// The present docks and bars are the default layout, which reset() restores.
  WindowLayout(QMainWindow& window, ToolBars& bars);

  /// Saves to the user's settings.
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
