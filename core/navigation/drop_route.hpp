// Finds the drops that lead from one part of a walkable area to another one on the shortest way.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Branch and bound. A way over drops is a chain of stretches and a place on each. Stretches are cut into pieces; for
// two pieces in turn, no way from any landing of the first to any start of the second is shorter than the straight line
// between both segments in the plan, nor than the shortest path between their middles less half the length of each,
// because one can walk along a piece. So Dijkstra's algorithm over pieces gives a lower bound. The paths along the
// chain that it finds are then computed, its pieces are halved, and it runs again, until the best way found is not much
// longer than that length. Where along its drops the best way runs is mended on its own: between the bends before and
// behind a drop, the length is a convex function of the place.
//
// Lengths are rounded; drops that start and end in one part are no part of any way, as nobody needs them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A drop on the way: where it is left and where one lands, on the lines from start to start and landing to landing.
struct DropStop {
  std::uint32_t drop = 0;
  Vec3 start, landing;
};

struct DropRoute {
  std::vector<DropStop> stops;
  double planLength = 0;
  double leastPlanLength = 0;  ///< lower bound of any way over drops
};

/// The shortest path between two places of one part.
struct RouteLeg {
  double planLength = 0;
  Vec3 first, last;  ///< its first bend, or its end; its last bend, or its start
  bool isStraight = false;
  std::size_t work = 0;  ///< nodes of the search
};

struct RouteEnd {
  Vec3 place;
  std::uint32_t triangle = 0;
};

using LegFinder = std::function<RouteLeg(const RouteEnd& from, const RouteEnd& to)>;

/// One flag per part: drops lead there from `part`, which is one of them.
std::vector<char> partsOverDrops(const NavigationMesh& mesh, const SurfaceTopology& topology, std::uint32_t part);

/// The drops from a place in one part to a place in another; empty where no drops lead there. The way is at most 1 %
/// longer than the shortest, or as good as a limited number of paths between drops allows; leastPlanLength has the
/// bound.
std::optional<DropRoute> findDropRoute(const NavigationMesh& mesh, const SurfaceTopology& topology,
                                       const RouteEnd& from, const RouteEnd& to, const LegFinder& legBetween,
                                       Poll poll);

}  // namespace footfall::detail
