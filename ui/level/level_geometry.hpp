// The level's geometry in the view: the environment with the roles of its parts, and the obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "ui/base/work/background_queue.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Follows the composer at once, so that the view and the level number triangles alike. Copies of more than 250,000
/// triangles are made in the background: the view, and its numbers of obstacles' triangles, are then a moment late;
/// numbers of the environment's triangles do not change.
class LevelGeometry : public QObject {
  Q_OBJECT

 public:
  LevelGeometry(LevelComposer& composer, LevelView& view, QObject* parent = nullptr);

  /// Called after the view was given another environment, as its file has it.
  void follow();

 private:
  void show(const std::shared_ptr<const EnvironmentGeometry>& geometry);

  LevelComposer& composer_;
  LevelView& view_;
  BackgroundQueue queue_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
