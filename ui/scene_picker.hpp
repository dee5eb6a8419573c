// What lies under the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/environment/environment.hpp"
#include "ui/render_geometry.hpp"

namespace footfall {

/// A line of sight. Directions need not be unit vectors.
struct Ray {
  Vec3 origin, direction;
};

/// A place on a triangle of the environment.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  Vec3 point;
};

/// Heights outside of these are cut away.
struct HeightRange {
  double lower = std::numeric_limits<double>::lowest();
  double upper = std::numeric_limits<double>::max();
  bool operator==(const HeightRange&) const = default;
};

Vec3 pointOn(const Ray& ray, double distance);

/// The ray's parameter where it meets the triangle, from either side; above 0. Nothing where it misses or lies in its
/// plane.
std::optional<double> meet(const Ray& ray, const std::array<Vec3, 3>& triangle);

/// The first triangle that the ray meets within `shown`. Ray, heights and result are in the scene's coordinates, those
/// of `geometry`. Looks at every triangle: 1 ms for about 100,000.
std::optional<SurfacePoint> pickSurface(const Ray& ray, const EnvironmentGeometry& geometry, const HeightRange& shown);

}  // namespace footfall
