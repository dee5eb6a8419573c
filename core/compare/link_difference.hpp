// The difference of the steps and gaps of two meshes as sets of points, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/comparison_surface.hpp"
#include "footfall/compare.hpp"

namespace footfall::detail::comparison {

/// Returns whether the length of a link is that of its first edge. The edges of a gap may differ in length, and their
/// order must be the same for all pieces of a gap: first the one towards larger x, or y.
bool isAlongFirstEdge(const NavigationMesh& mesh, const StepLink& link);

/// A step is the points (x, y, lower height, upper height) over a stretch of the plan: a segment in four dimensions,
/// its ends at the rounded vertices. So two steps have more than a point in common only on one line of that space, and
/// on each line intervals are subtracted. Steps cut into other pairs of edges are the same where the cuts lie on the
/// line, as they do where nothing was rounded; so on level floors. A gap is the pairs of places between which ways lead
/// over it, six numbers each, and compared with gaps in the same way.
///
/// `surfaces` must be of `a` and `b`. Throws Cancelled.
LinkDifference subtractLinks(const ComparedSurfaces& surfaces, const NavigationMesh& a, const NavigationMesh& b,
                             RunContext& context);

}  // namespace footfall::detail::comparison
