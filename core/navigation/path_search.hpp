// The search for shortest paths over triangles (Polyanya). What callers use is core/navigation/path_finder.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cui, Harabor and Grastien, "Compromise-free Pathfinding on a Navigation Mesh" (IJCAI 2017). A node of the search is
// what can be seen from a *root* (the start, or a corner that the path bends around) through one side of a triangle;
// nodes are taken in the order of the shortest length that a path through them can have. All triangles face up, so
// neighbouring ones lie on different sides of their common side in the plan, and what one sees can be unrolled there
// without a change: layers above each other are different triangles and never meet. Shortest means in the plan.
//
// Exactness. Interval ends are not points here, as they would have to be rounded; a node's cone is kept as two lines
// through a root and a mesh vertex each, or through two roots: always through points whose coordinates are the given
// doubles. Whether a vertex lies inside the cone, left of it or right of it is then an exact orientation of three given
// points, and so is whether the goal is in sight. What is rounded: lengths (sums of square roots), and the ends of
// intervals as far as they bound lengths from below. They can change which of two paths is taken whose lengths differ
// by rounding, but never whether there is one, nor where it runs through the surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A path as the search finds it: from the start in `startTriangle` through sides, in order, to the goal.
struct SidePath {
  struct Crossing {
    std::uint32_t triangle;  ///< triangle that is entered
    int side;                ///< its side
    std::uint32_t root;      ///< the path comes straight from this fan, or from the start (kNone)
  };
  bool found = false;
  std::uint32_t startTriangle = 0;
  std::vector<Crossing> crossings;
  std::uint32_t lastBend = SurfaceTopology::kNone;  ///< a fan in the last triangle before the goal, or kNone
  std::size_t expanded = 0;                         ///< nodes that were looked at
};

/// `start` and `goal` lie in the closed plan of their triangles (exactly). They are taken to be in all triangles around
/// the side or the fan on which they lie. Throws what `poll` throws.
SidePath searchPath(const NavigationMesh& mesh, const SurfaceTopology& topology, const Vec3& start,
                    std::uint32_t startTriangle, const Vec3& goal, std::uint32_t goalTriangle, Poll poll);

}  // namespace footfall::detail
