// Environments of any size for measuring growth: the same bytes on every machine, coordinates on a grid of 1/64 m.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "footfall/environment.hpp"

namespace footfall::bench {

/// About `triangles` triangles (within 3 % from 10,000 on): hills of squares of 1 m with a box for every 24 squares,
/// half of them standing in the ground and half hanging too low to pass under. Their density does not depend on the
/// size.
Environment makeTerrain(std::uint32_t triangles);

/// One floor of two triangles under boxes of altogether `obstacleTriangles` triangles, one for each 12 square metres.
/// Some stand in one another.
Environment makeGiantFloor(std::uint32_t obstacleTriangles);

/// Writes an environment's triangles as OBJ with Y up. Throws RunError.
void writeEnvironment(const std::string& path, Environment environment);

}  // namespace footfall::bench
