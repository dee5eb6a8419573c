// More vertices where a floor's triangles are long and thin.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All triangles between a straight border and many small corners (a row of posts, a comb) come together at the ends of
// the straight border, even in a Delaunay triangulation. Then each of n margins lies on all triangles that come past it
// from far away, and cutting takes the square of n. New vertices in the middle of the longest inner edges end that:
// each halves the way from which triangles come (the longest edge as in M. C. Rivara, "Algorithms for refining
// triangular grids suitable for adaptive and multigrid techniques", 1984), and edges are flipped towards Delaunay
// again.
#pragma once

#include "core/base/poll.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// Divides triangles of a product, which is not divided into layers, that are thinner than `width`, and whose longest
/// edge is longer than eight times that and lies inside a level floor. Only where there are many of them; then
/// `triangles`, `sourceTriangles` and `vertices` have more at their ends, edges inside of level floors change, and all
/// else stays, but for the triangles that links name. Every triangle still faces up, exactly, and the area is the same.
void divideThinTriangles(NavigationMesh& product, double width, const Poll& poll);

}  // namespace footfall::detail
