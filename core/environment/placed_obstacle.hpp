// Obstacles that the user places into an environment: simple shapes with a place, a size and a turn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "footfall/edit.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

struct PlacedObstacle {
  /// A ramp rises along its own x axis, from nothing to its full height.
  enum class Shape { Box, Cylinder, Ramp };
  std::uint32_t id = 0;  ///< unique in its document
  Shape shape = Shape::Box;
  std::string name;
  Vec3 base;        ///< middle of its bottom, in the environment's frame (Z up) and units
  Vec3 size;        ///< extents along its own axes before the turn, each above 0
  double turn = 0;  ///< degrees about Z, counter-clockwise from above
  bool operator==(const PlacedObstacle&) const = default;
};

/// Cosine and sine of an angle in degrees; exactly 0 and 1 at multiples of 90.
std::array<double, 2> directionOf(double degrees);

/// A place given along the obstacle's own axes from the middle of its bottom, in the environment's frame; not rounded
/// as the corners of soups are.
Vec3 placeOn(const PlacedObstacle& obstacle, const Vec3& local);

/// The surface of an obstacle: closed, facing outward, 12 triangles for a box, 8 for a ramp, 92 for a cylinder (24
/// sides; an ellipse where its extents differ). Turns by multiples of 90 degrees leave boxes and ramps parallel to the
/// axes to the last bit, and bottoms and tops lie at exactly base.z and base.z + size.z: what stands on a floor touches
/// it. Other turns are rounded to a 16 millionth of the smaller extent, so that they need few digits. Throws InputError
/// for an extent that is not above 0 or a number that is not finite.
TriangleSoup soupOf(const PlacedObstacle& obstacle);

/// The surface with faces inside, which look down and are at most `spacing` apart: a hollow obstacle that is higher
/// than the clearance would have a walkable floor within. At most 64 of them, farther apart where that does not
/// suffice.
TriangleSoup solidSoupOf(const PlacedObstacle& obstacle, double spacing);

}  // namespace footfall::detail
