// Splitting triangles at vertices that lie beside their edges: T-joints that rounding to a grid has opened.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Levels with more triangles or vertices than these are left as they are, so that packing, which holds no more in
/// memory, gives the same.
inline constexpr std::uint64_t kMostSplitTriangles = std::uint64_t{1} << 20,
                               kMostSplitVertices = std::uint64_t{1} << 22;

/// A vertex that lies on an edge in the file is up to a step beside it on the grid: a slit, narrower than a step,
/// through which a point gets past a wall. Every edge of a triangle with vertices nearer than one step to it, between
/// its ends, becomes the polyline through them. An edge with more than eight of them stays as it is: it is one of a
/// giant floor, and a fan of needles as long as the floor would cost more than the slits do. An upright triangle is not
/// split: its pieces would lean, and cut slivers out of floors. What is near is decided
/// exactly, in whole steps; all triangles at an edge get the same vertices, whatever the order of the input.
///
/// All coordinates are multiples of `step`. A triangle that is split keeps its number for the first of its pieces; the
/// others stand at the end of the list. One that lies between the polylines of its edges has no area any more. Returns
/// the number of triangles that were split.
std::uint64_t splitAtNearVertices(Environment& environment, double step, const Poll& poll);

}  // namespace footfall::detail
