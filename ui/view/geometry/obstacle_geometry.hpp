// The geometry of placed obstacles: appended to the environment's geometry, and as edges for overlays.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/environment/placed_obstacle.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// The geometry of `level`, whose first `first` triangles are those of `base` and are copied (1 ms for 60,000
/// triangles). The centre stays.
std::shared_ptr<const EnvironmentGeometry> withObstacles(const std::shared_ptr<const EnvironmentGeometry>& base,
                                                         const Environment& level, std::size_t first);

/// The edges that show its shape, and its triangles; both empty for an obstacle that soupOf() refuses.
struct ObstacleShape {
  std::vector<std::array<Vec3, 2>> edges;
  std::vector<std::array<Vec3, 3>> triangles;
};
ObstacleShape shapeOf(const PlacedObstacle& obstacle);

}  // namespace footfall::ui
