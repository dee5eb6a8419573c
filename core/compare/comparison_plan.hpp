// The part of a surface that another one covers when heights may differ a little.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/compare/comparison_sets.hpp"
#include "core/compare/cover_triangles.hpp"

namespace footfall::detail::comparison {

/// The area, for each triangle of A and of B, of the part that has no point of the other surface straight above or
/// below within `height`. `height` must have been given to makeSurfaces(). Triangles are looked at one by one, so
/// storeys do not disturb each other. Parts that are covered in `difference` count as covered; all other vertical
/// triangles neither cover anything nor are covered.
///
/// Corners that arise where the height is reached are rounded to 2^-192 of the extent; everything else is exact.
std::array<std::vector<SurfaceArea>, 2> findUncovered(const ComparedSurfaces& surfaces, const SetDifference& difference,
                                                      double height, RunContext& context);

/// The part of one triangle that findUncovered() measures.
struct UncoveredPart {
  std::uint32_t triangle = 0;  ///< triangle of the surface
  SurfaceArea areas;
  /// Corners in units of the meshes; `point` is the number of a position, else kNoPoint.
  std::vector<CoverTriangle> triangles;
};

/// The same as parts to draw: for A and for B, only triangles of which something is not covered, rising.
std::array<std::vector<UncoveredPart>, 2> findUncoveredParts(const ComparedSurfaces& surfaces,
                                                             const SetDifference& difference, double height,
                                                             RunContext& context);

}  // namespace footfall::detail::comparison
