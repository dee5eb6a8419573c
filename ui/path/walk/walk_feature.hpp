// Everything that walks: the walker on the path of "Try it", and the walk in first person.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/path/path_model.hpp"
#include "ui/path/walk/walk_bar.hpp"
#include "ui/path/walk/walk_tool.hpp"
#include "ui/path/walk/walker.hpp"
#include "ui/path/walk/walker_view.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

class WalkFeature : public QObject {
  Q_OBJECT

 public:
  WalkFeature(const FeatureHost& host, LevelView& view, PathModel& model, QObject* parent);

  /// The controls, for the panel of the path, which takes them over.
  [[nodiscard]] WalkBar* bar() { return bar_; }
  /// The result, and the radius of the agent that it is for, in the environment's units; 0: none.
  void setGround(const PathModel::Ground& ground, double radius, double metresPerUnit);
  /// The radius of the body that walks the path; 0: that of setGround().
  void setBodyRadius(double radius);
  /// Metres a second.
  void setSpeed(double speed);
  /// Whether the path, and the walker on it, are shown.
  void setShown(bool shown);

  [[nodiscard]] Walker& walker() { return walker_; }
  [[nodiscard]] WalkerView& walkerView() { return walkerView_; }
  [[nodiscard]] WalkTool& tool() { return tool_; }

 private:
  void takePath();

  PathModel& model_;
  Walker walker_;
  WalkerView walkerView_;
  WalkTool tool_;
  WalkBar* bar_;
  QAction* play_;
  double metresPerUnit_ = 1;
  double height_ = 0, groundRadius_ = 0;  ///< of the agent that the ground is for
  double speed_ = 1.4;
};

}  // namespace footfall::ui
