// The level in the view: the geometry of the environment with the roles of its parts, and of obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/level_composer.hpp"
#include "ui/level_view.hpp"

namespace footfall {

/// Follows the composer at once, so that numbers of triangles mean the same in the view and in the level.
class LevelGeometry : public QObject {
  Q_OBJECT

 public:
  LevelGeometry(LevelComposer& composer, LevelView& view, QObject* parent = nullptr);

  /// After the view was given another environment, as its file has it.
  void follow();

 private:
  LevelComposer& composer_;
  LevelView& view_;
};

}  // namespace footfall
