// Finds the surfaces on which obstacles may stand, under the mouse and under a place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <cstdint>
#include <optional>

#include "ui/level/level_composer.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Leaves out one obstacle, the moved one. Places are in the environment; their heights are exact on horizontal
/// triangles, so that obstacles touch them.
class ObstacleGround {
 public:
  ObstacleGround(const LevelView& view, const LevelComposer& composer) : view_(view), composer_(composer) {}

  /// The place that is visible at a point of the view.
  [[nodiscard]] std::optional<Vec3> at(const QPoint& place, std::optional<std::uint32_t> without = {}) const;
  /// The highest floor (facing up) at or below a place.
  [[nodiscard]] std::optional<Vec3> under(const Vec3& place, std::optional<std::uint32_t> without = {}) const;
  /// The obstacle that is visible at a point of the view.
  [[nodiscard]] std::optional<std::uint32_t> obstacleAt(const QPoint& place) const;

 private:
  [[nodiscard]] Vec3 exactOn(std::uint32_t triangle, const Vec3& place) const;

  const LevelView& view_;
  const LevelComposer& composer_;
};

}  // namespace footfall::ui
