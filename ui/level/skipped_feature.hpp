// Brings what import left out into the window: a panel, a way to it, and marks in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <QPushButton>

#include "ui/level/skipped_panel.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<SkippedFeature*>().
class SkippedFeature : public QObject {
  Q_OBJECT

 public:
  explicit SkippedFeature(EditorWindow& window);

  [[nodiscard]] SkippedPanel& panel() { return *panel_; }
  /// In the panel of the environment; hidden while nothing was left out.
  [[nodiscard]] QPushButton* showButton() const { return show_; }

 private:
  void follow();
  void frame(int row);

  EditorWindow& window_;
  SkippedPanel* panel_;
  QDockWidget* dock_;
  QPushButton* show_;
};

}  // namespace footfall::ui
