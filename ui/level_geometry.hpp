// The level in the view: the loaded environment's geometry, without what is ignored and with obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "ui/background_queue.hpp"
#include "ui/level_composer.hpp"
#include "ui/level_view.hpp"

namespace footfall {

/// Follows the composer at once, so that numbers of triangles mean the same in the view and in the level. Lines of
/// parts that are ignored go a moment later, when the background has found the edges of what is left.
class LevelGeometry : public QObject {
  Q_OBJECT

 public:
  LevelGeometry(LevelComposer& composer, LevelView& view, QObject* parent = nullptr);

  /// The view shows another environment, as its file gave it.
  void setLoaded(std::shared_ptr<const Environment> environment);

 private:
  void follow();
  void makeBase();

  LevelComposer& composer_;
  LevelView& view_;
  std::shared_ptr<const Environment> loaded_, base_;
  std::shared_ptr<const EnvironmentGeometry> ofLoaded_, ofBase_;
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall
