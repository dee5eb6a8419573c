// Points and triangles, as every part of Footfall has them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace footfall {

/// A point or a vector in double precision. Of environments and results: Z up, the environment's units.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  bool operator==(const Vec3&) const = default;
};

/// Numbers of three vertices, counter-clockwise seen from the front.
using Triangle = std::array<std::uint32_t, 3>;

/// Vertices and the triangles over them.
struct TriangleSoup {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

}  // namespace footfall
