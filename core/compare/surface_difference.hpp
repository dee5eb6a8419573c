// The difference of two navigation meshes as sets of points: as triangles to draw, and as a list of regions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/compare/comparison_sets.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// A part of the difference that hangs together: in a plane over more than a point, and over corners from plane to
/// plane.
struct DifferentRegion {
  std::uint32_t mesh = 0;  ///< the mesh that has it: 0 or 1
  double area = 0;         ///< surface area of its triangles: rounded
  Vec3 lower, upper;       ///< the box around it
};

struct SurfaceDifference {
  /// The parts that only the first mesh and only the second have. Their existence is exact, areas have 14 digits.
  std::array<bool, 2> hasArea{};
  std::array<SurfaceArea, 2> areas;
  /// The same as triangles, with corners rounded to doubles and in the winding of an area that faces up.
  std::array<std::vector<std::array<Vec3, 3>>, 2> triangles;
  /// The index in `regions` of each triangle.
  std::array<std::vector<std::uint32_t>, 2> regionOf;
  std::vector<DifferentRegion> regions;  ///< largest first

  [[nodiscard]] bool empty() const { return !hasArea[0] && !hasArea[1]; }
};

/// Triangles that both meshes have, corner by corner, are left out first, unless they are near to one that they have
/// not: so two results of one level of 60,000 triangles take about 0.1 s where little has changed. On all threads; the
/// same input gives the same result. Throws Cancelled.
///
/// `height`: what the other mesh has straight above or below within it is no difference, as sloped floors that are
/// triangulated anew lie in other planes by a rounding; 0: exactly the difference of the sets.
SurfaceDifference subtractSurfaces(const NavigationMesh& first, const NavigationMesh& second, RunContext& context,
                                   double height = 0);

/// A height that is far more than rounding vertices to doubles moves them, and far less than a step: 2^-30 of the
/// largest coordinate, as ComparisonOptions::height.
double roundingHeight(const NavigationMesh& first, const NavigationMesh& second);

}  // namespace footfall::detail
