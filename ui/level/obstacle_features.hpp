// Obstacles in the editor: tools, commands, the dock, and the update of the level in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <vector>

#include "ui/level/level_file.hpp"
#include "ui/level/level_geometry.hpp"
#include "ui/level/obstacle_editor.hpp"
#include "ui/level/obstacle_panel.hpp"
#include "ui/level/obstacle_tools.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<ObstacleFeatures*>().
class ObstacleFeatures : public QObject {
  Q_OBJECT

 public:
  ObstacleFeatures(const FeatureHost& host, LevelView& view, Document& document, LevelFile& file,
                   LevelComposer& composer, RunController& controller);

  [[nodiscard]] ObstacleEditor& editor() { return *editor_; }
  [[nodiscard]] SelectObstacleTool& selectTool() { return *select_; }
  [[nodiscard]] PlaceObstacleTool& placeTool(PlacedObstacle::Shape shape);
  [[nodiscard]] ObstaclePanel& panel() { return *panel_; }

 protected:
  /// An active tool uses Esc, so that it does not cancel the run; page keys move the selected obstacle.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void followLevel();
  void createTools(const FeatureHost& host);
  void createPanel(const FeatureHost& host);
  void createCommands(CommandRegistry& commands);
  void showSelection();
  void boundSelection();
  void frame(std::uint32_t id);
  void duplicate();

  LevelView& view_;
  LevelFile& file_;
  LevelComposer& composer_;
  RunController& controller_;
  UnitChoice& units_;
  LevelGeometry* geometry_;
  ObstacleEditor* editor_ = nullptr;
  SelectObstacleTool* select_ = nullptr;
  std::vector<PlaceObstacleTool*> place_;
  ObstaclePanel* panel_ = nullptr;
  QDockWidget* dock_ = nullptr;
};

}  // namespace footfall::ui
