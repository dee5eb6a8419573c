// The level in the view: the geometry of the environment with the roles of its parts, and of obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "ui/base/background_queue.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Follows the composer at once, so that numbers of triangles mean the same in the view and in the level. For more than
/// 250,000 triangles the copies are made in the background: the view is then a moment behind, and numbers of obstacles'
/// triangles with it; those of the environment stay what they are.
class LevelGeometry : public QObject {
  Q_OBJECT

 public:
  LevelGeometry(LevelComposer& composer, LevelView& view, QObject* parent = nullptr);

  /// After the view was given another environment, as its file has it.
  void follow();

 private:
  void show(const std::shared_ptr<const EnvironmentGeometry>& geometry);

  LevelComposer& composer_;
  LevelView& view_;
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
