// The handles of a selected obstacle: where they are, which one is under the mouse, and what dragging one does.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <functional>
#include <optional>

#include "core/environment/placed_obstacle.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/scene_picker.hpp"
#include "ui/view/view_overlay.hpp"

namespace footfall::ui {

/// What moves an obstacle along an axis of the environment or in the plan, turns it, or moves one of its sides.
enum class ObstacleHandle { MoveX, MoveY, MoveZ, MovePlan, Turn, LowerX, UpperX, LowerY, UpperY, Top };

/// How the view looks at the handles.
struct GizmoView {
  std::function<std::optional<QPointF>(const Vec3&)> project;
  double unitsPerPixel = 1;  ///< at the obstacle
};

/// Handles keep their size on the screen: arrows of 90 pixels from the obstacle's middle (longer where it is larger), a
/// square between two of them, a ring around its foot, and a cube outside of each side but the bottom. Handles whose
/// axis is seen from its end are not there: the mouse could not move them.
class ObstacleGizmo {
 public:
  ObstacleGizmo(const PlacedObstacle& obstacle, const GizmoView& view);

  /// The handle at a place of the view, cubes first. Nothing farther than 8 pixels away.
  [[nodiscard]] std::optional<ObstacleHandle> at(const QPointF& place) const;
  /// The handles, the one that is hovered or held highlighted.
  [[nodiscard]] ViewOverlay overlay(std::optional<ObstacleHandle> marked) const;
  /// Where a handle can be taken, in the environment.
  [[nodiscard]] Vec3 placeOf(ObstacleHandle handle) const;

 private:
  [[nodiscard]] bool isThere(ObstacleHandle handle) const;
  [[nodiscard]] Vec3 arrowTip(ObstacleHandle handle) const;
  [[nodiscard]] Vec3 planCorner(int corner) const;
  [[nodiscard]] double ringRadius() const;
  [[nodiscard]] std::vector<Vec3> ring() const;
  [[nodiscard]] std::optional<double> distanceTo(const QPointF& place, const std::vector<Vec3>& line) const;

  PlacedObstacle obstacle_;
  GizmoView view_;
};

/// Lengths and places are rounded to `length`, turns to `degrees`; `toGrid` rounds places themselves, and not how far
/// they have moved.
struct DragSteps {
  double length = 0.01;
  double degrees = 1;
  bool toGrid = false;
};

/// `start` as it becomes when `handle` was taken on the line of sight `from` and is now on `to`; nothing when a line of
/// sight does not tell (it runs along the axis, or past the horizon). Extents stay at least one step.
std::optional<PlacedObstacle> dragged(const PlacedObstacle& start, ObstacleHandle handle, const Ray& from,
                                      const Ray& to, const DragSteps& steps);

}  // namespace footfall::ui
