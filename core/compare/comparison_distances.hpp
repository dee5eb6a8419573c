// The distances between two surfaces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/compare/comparison_surface.hpp"
#include "footfall/compare.hpp"

namespace footfall::detail::comparison {

/// The distances from A to B and from B to A. `known[i]` is a bound that no point of triangle i exceeds, infinite where
/// none is known, and 0 where the triangle lies in the other surface, exactly. Samples that lie exactly on the other
/// surface have distance 0; others are computed in doubles. Further bounds come from subdividing: the distance to one
/// triangle is convex, so over a piece it is largest at a corner. Pieces are halved until none can be farther than
/// `error` beyond the farthest point found, or there have been too many.
///
/// Both surfaces must have triangles. The same input gives the same bits, with any number of threads.
std::array<SurfaceDistances, 2> measureDistances(const ComparedSurfaces& surfaces,
                                                 const std::array<std::vector<double>, 2>& known, double error,
                                                 RunContext& context);

/// The distance to B of each position that A uses, as measureDistances() samples it; 0 for others. Both surfaces must
/// have triangles.
std::vector<double> distancesOfPositions(const ComparedSurfaces& surfaces, RunContext& context);

}  // namespace footfall::detail::comparison
