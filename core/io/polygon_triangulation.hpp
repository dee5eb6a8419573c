// Splitting the polygons of a file into triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Appends triangles that cover the polygon with these `corners` (indices into `vertices`, any orientation, convex or
/// not, nearly planar), wound like the polygon. Three corners are one triangle, even of zero area.
///
/// The polygon is projected along the coordinate axis that is nearest to its normal (Newell's method), which keeps the
/// exact coordinates of its corners. There, the fan from the first corner is taken when each of its triangles turns the
/// same way as the polygon; otherwise ears are clipped (Meisters 1975; ElGindy, Everett and Toussaint 1993 show that
/// one always exists in a simple polygon). Clipping can take n^3; above kMostClippedCorners the outline is triangulated
/// in n log n instead (outline_triangulation.hpp). All turns are exact. A polygon that crosses itself or has no area is
/// covered by a fan, so that none of it is lost.
///
/// Returns false, and appends nothing, when fewer than three of the corners are distinct vertices. A corner that
/// follows itself counts once. `poll` is called from time to time for large polygons and may throw to cancel.
bool triangulatePolygon(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                        std::vector<Triangle>& triangles, Poll poll = {});

/// The most corners of a polygon whose ears are clipped; clipping then takes some milliseconds for any shape.
inline constexpr std::size_t kMostClippedCorners = 500;

}  // namespace footfall::detail
