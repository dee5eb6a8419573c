// The walkable area with exact coordinates, for tests and for tools that cannot live with rounding.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/assembly/recall.hpp"

namespace footfall::detail {

struct ExactTriangle {
  /// Corners, counter-clockwise from above; x, y, z as rationals "p" or "p/q", Z up, environment units.
  std::array<std::array<std::string, 3>, 3> corners;
  std::uint32_t sourceTriangle = 0;    ///< an input triangle in whose plane it lies
  std::array<bool, 3> obstacleEdge{};  ///< edge k from corner k to k + 1
  int layer = -1;                      ///< -1 when no layer filter ran
};

/// The walkable triangles of a state. When no filter has needed a mesh yet, the source triangles themselves.
std::vector<ExactTriangle> exactWalkableTriangles(const WalkableState& state);

}  // namespace footfall::detail
