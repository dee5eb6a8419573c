// Brings the comparison of two results into the window: panel, commands, what is drawn, and the legend.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>

#include "ui/inspect/compare_panel.hpp"
#include "ui/inspect/compare_watch.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<CompareFeature*>().
class CompareFeature : public QObject {
  Q_OBJECT

 public:
  explicit CompareFeature(EditorWindow& window);

  [[nodiscard]] CompareWatch& watch() { return *watch_; }
  [[nodiscard]] ComparePanel& panel() { return *panel_; }
  /// Compares with an exported result; shows the panel.
  void openSaved(const QString& path);

 private:
  void addCommands();
  void choose(int choice);
  void chooseFile();
  void showPanel();
  void takeResult();
  void show();
  void draw();
  void frame(int region);
  [[nodiscard]] CompareWriter writer() const;

  EditorWindow& window_;
  CompareWatch* watch_;
  ComparePanel* panel_;
  QDockWidget* dock_;
  QAction* lastEdit_ = nullptr;
  int chosenRegion_ = -1;
  bool isComputed_ = false;  ///< a run has started since the last result
};

}  // namespace footfall::ui
