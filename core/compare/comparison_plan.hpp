// What of a surface another one covers when heights may differ a little.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/compare/comparison_sets.hpp"
#include "core/compare/cover_triangles.hpp"

namespace footfall::detail::comparison {

/// For each triangle of A and of B, the area of that part of it from which straight up or down, within `height`, there
/// is no point of the other surface. `height` must have been given to makeSurfaces(). Triangles are looked at one by
/// one, so storeys do not disturb each other. What `difference` knows to be covered is; vertical triangles besides
/// neither cover anything nor are covered.
///
/// Corners that arise where the height is reached are rounded to 2^-192 of the extent; everything else is exact.
std::array<std::vector<SurfaceArea>, 2> findUncovered(const ComparedSurfaces& surfaces, const SetDifference& difference,
                                                      double height, RunContext& context);

/// The part of one triangle that findUncovered() measures.
struct UncoveredPart {
  std::uint32_t triangle = 0;  ///< of the surface
  SurfaceArea areas;
  /// Corners in units of the meshes; `point` is the number of a position, else kNoPoint.
  std::vector<CoverTriangle> triangles;
};

/// The same as parts to draw: for A and for B, only triangles of which something is not covered, rising.
std::array<std::vector<UncoveredPart>, 2> findUncoveredParts(const ComparedSurfaces& surfaces,
                                                             const SetDifference& difference, double height,
                                                             RunContext& context);

}  // namespace footfall::detail::comparison
