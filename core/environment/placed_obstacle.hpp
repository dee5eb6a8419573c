// Obstacles that the user places into an environment: simple shapes with a place, a size and a turn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/environment/environment.hpp"

namespace footfall {

struct PlacedObstacle {
  enum class Shape { Box, Cylinder, Ramp };
  std::uint32_t id = 0;  ///< unique in its document
  Shape shape = Shape::Box;
  std::string name;
  Vec3 base;        ///< middle of its bottom, in the environment's frame (Z up) and units
  Vec3 size;        ///< extents along its own axes before the turn, each above 0
  double turn = 0;  ///< degrees about Z, counter-clockwise from above
  bool operator==(const PlacedObstacle&) const = default;
};

}  // namespace footfall
