// "Try it": tool, panel, the result that paths use, and the session section.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <string>

#include "ui/level/level_file.hpp"
#include "ui/path/passage_view.hpp"
#include "ui/path/path_model.hpp"
#include "ui/path/path_panel.hpp"
#include "ui/path/path_tool.hpp"
#include "ui/path/separation_view.hpp"
#include "ui/path/walk/walk_feature.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"

class QDockWidget;

namespace footfall::ui {

class PathFeature : public QObject {
  Q_OBJECT

 public:
  PathFeature(const FeatureHost& host, LevelView& view, Document& document, LevelFile& file, RunController& controller);

  [[nodiscard]] PathModel& model() { return model_; }
  [[nodiscard]] WalkFeature& walk() { return *walk_; }

 private:
  void connectModel(const FeatureHost& host);
  void takeResult();
  void takeBody();
  void follow();
  void boundSelection();
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

  LevelView& view_;
  LevelFile& file_;
  RunController& controller_;
  PathModel model_;
  PathTool tool_;
  PathPanel* panel_;
  PassageView* passage_;
  SeparationView* separation_;
  WalkFeature* walk_;
  QDockWidget* dock_;
  std::string environment_;   ///< file that the places lie in
  bool fromSession_ = false;  ///< the places came with the file that is being opened
};

}  // namespace footfall::ui
