// Two meshes made comparable: equal positions have one number in both, and all coordinates are integers of one grid.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <vector>

#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail::comparison {

/// The positions of both meshes' triangles and steps, each once, sorted by x, y, z. Nothing that is computed from them
/// depends on the order of vertices or triangles in the files.
struct Positions {
  std::vector<Vec3> places;
  /// The same as integers times 2^unit.
  std::vector<std::array<mpz_class, 3>> integers;
  int unit = 0;
  int width = 0;  ///< all integers are below 2^width in size

  [[nodiscard]] std::size_t size() const { return places.size(); }
};

/// One of the two meshes. Only triangles with an area: all others are no part of the set.
struct Surface {
  std::vector<Triangle> triangles;       ///< numbers of positions, in the order of the file
  std::vector<std::uint32_t> numbers;    ///< number in the file of each triangle
  std::vector<std::uint32_t> positions;  ///< those in use, each once, rising
};

struct ComparedSurfaces {
  Positions positions;
  std::array<Surface, 2> surfaces;  ///< A and B
};

/// `extra` is another number that has to lie on the grid (a height).
ComparedSurfaces makeSurfaces(const NavigationMesh& a, const NavigationMesh& b, double extra, RunContext& context);

/// The double as an integer of the grid; exact where it lies on it.
mpz_class onGrid(double x, int unit);

/// The cross product of two sides, in squared units of the grid.
std::array<mpz_class, 3> exactNormal(const Positions& positions, const Triangle& triangle);

}  // namespace footfall::detail::comparison
