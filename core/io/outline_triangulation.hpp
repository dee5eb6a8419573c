// The triangulation of polygons with many corners, in the plane.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Triangulates the inside of the polygon with these corners, seen from z, as triangles of corner numbers that turn the
/// polygon's way: the constrained Delaunay triangulation of its outline (CGAL's; all decisions are exact). Expected
/// time is n log n: points are inserted in a shuffled order along a curve (Amenta, Choi and Rote 2003), and edges in a
/// shuffled order (Shewchuk and Brown 2015). The shuffling is fixed and the triangles are sorted, so that the same
/// polygon gives the same triangles on every machine.
///
/// The outline may touch itself and run along itself, as bridges to holes do. The first of several corners at one place
/// stands for all of them. The result is empty when the outline crosses itself or covers a place twice, when corners
/// lie straight above each other, and when there is no area.
///
/// `poll` is called every few microseconds and may throw to cancel.
std::vector<std::array<std::size_t, 3>> triangulateOutline(std::span<const Vec3> corners, Poll poll);

}  // namespace footfall::detail
