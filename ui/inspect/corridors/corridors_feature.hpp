// "Corridors": the panel, the map and the bottlenecks in the view, and the session section.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <string>

#include "ui/inspect/corridors/corridor_watch.hpp"
#include "ui/inspect/corridors/corridors_panel.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<CorridorsFeature*>().
class CorridorsFeature : public QObject {
  Q_OBJECT

 public:
  CorridorsFeature(const FeatureHost& host, LevelView& view, LevelFile& file, RunController& controller);

  [[nodiscard]] CorridorWatch& watch() { return *watch_; }
  [[nodiscard]] CorridorsPanel& panel() { return *panel_; }

 private:
  void connectPanel(const FeatureHost& host);
  void follow();
  void takeLevel();
  void takeUsualWidth();
  void show();
  void drawMap();
  void drawBottlenecks();
  void drawChosen();
  void choose(int row);
  void frame(int row);
  [[nodiscard]] QString noteOf() const;
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

  LevelView& view_;
  LevelFile& file_;
  RunController& controller_;
  UnitChoice& units_;
  CorridorWatch* watch_;
  CorridorsPanel* panel_;
  QDockWidget* dock_;
  int chosen_ = -1;            ///< row of the list; -1: none
  bool isWidthGiven_ = false;  ///< by the user or a session; else the width follows the filter Radius
  bool fromSession_ = false;   ///< the width came with the file that is being opened
  std::string environment_;    ///< file that the width belongs to
};

}  // namespace footfall::ui
