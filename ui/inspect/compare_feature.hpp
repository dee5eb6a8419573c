// The comparison of two results: panel, commands, overlays and legend entries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>

#include "ui/document/document.hpp"
#include "ui/inspect/compare_panel.hpp"
#include "ui/inspect/compare_watch.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/widgets/view_layout.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<CompareFeature*>().
class CompareFeature : public QObject {
  Q_OBJECT

 public:
  CompareFeature(const FeatureHost& host, LevelView& view, ViewLayout& layout, Document& document, LevelFile& file,
                 RunController& controller);

  [[nodiscard]] CompareWatch& watch() { return *watch_; }
  [[nodiscard]] ComparePanel& panel() { return *panel_; }
  /// Compares with an exported result and shows the panel.
  void openSaved(const QString& path);

 private:
  void addCommands(CommandRegistry& commands);
  void choose(int choice);
  void chooseFile();
  void showPanel();
  void takeResult();
  void show();
  void draw();
  void drawDifference(const SurfaceDifference& difference);
  void drawDistances(const DistanceBands& bands);
  [[nodiscard]] QString distanceLine(const DistanceBands& bands) const;
  void frame(int region);
  [[nodiscard]] CompareWriter writer() const;

  QWidget& window_;  ///< parent of dialogs
  LevelView& view_;
  ViewLayout& layout_;
  Document& document_;
  LevelFile& file_;
  RunController& controller_;
  UnitChoice& units_;
  CompareWatch* watch_;
  ComparePanel* panel_;
  QDockWidget* dock_;
  QAction* lastEdit_ = nullptr;
  int chosenRegion_ = -1;
  bool isComputed_ = false;  ///< a run has started since the last result
};

}  // namespace footfall::ui
