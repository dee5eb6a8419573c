// The handles of a selected obstacle: their places, the one under the mouse, and the effect of dragging.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <functional>
#include <optional>

#include "core/environment/placed_obstacle.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/overlays/view_overlay.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {

/// A handle that moves an obstacle along an axis of the environment or in the plan, turns it, or moves one of its
/// sides.
enum class ObstacleHandle { MoveX, MoveY, MoveZ, MovePlan, Turn, LowerX, UpperX, LowerY, UpperY, Top };

/// The view of the handles.
struct GizmoView {
  std::function<std::optional<QPointF>(const Vec3&)> project;
  double unitsPerPixel = 1;  ///< at the obstacle
};

/// Handles have a constant size on the screen: arrows of 90 pixels from the obstacle's middle (longer where it is
/// larger), a square between two of them, a ring around its foot, and a cube outside of each side except the bottom.
/// There is no handle whose axis is seen from its end, because the mouse could not move it.
class ObstacleGizmo {
 public:
  ObstacleGizmo(const PlacedObstacle& obstacle, const GizmoView& view);

  /// The handle at a place of the view, cubes first, at most 8 pixels away.
  [[nodiscard]] std::optional<ObstacleHandle> at(const QPointF& place) const;
  /// The handles, with the hovered or held one highlighted.
  [[nodiscard]] ViewOverlay overlay(std::optional<ObstacleHandle> marked) const;
  /// The place in the environment where a handle can be taken.
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

/// Lengths and places are rounded to `length`, turns to `degrees`. `toGrid` rounds the places themselves, and not their
/// movement.
struct DragSteps {
  double length = 0.01;
  double degrees = 1;
  bool toGrid = false;
};

/// The obstacle `start` after `handle` was taken on the line of sight `from` and moved to `to`. Empty where a line of
/// sight gives no place (it runs along the axis, or past the horizon). Extents stay at least one step.
std::optional<PlacedObstacle> dragged(const PlacedObstacle& start, ObstacleHandle handle, const Ray& from,
                                      const Ray& to, const DragSteps& steps);

}  // namespace footfall::ui
