// Borders of a walkable area, and the shortest ways from one to another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/path.hpp"

namespace footfall::detail {

/// The parts of a mesh: what hangs together over edges and over all of its steps, also those that paths do not take
/// because a side leads to several (SurfaceTopology).
struct SurfaceParts {
  std::vector<std::uint32_t> of;  ///< component of each triangle, numbered from 0 by first triangles;
                                  ///< SurfaceTopology::kNone
  std::uint32_t count = 0;
};
SurfaceParts findSurfaceParts(const NavigationMesh& mesh, const SurfaceTopology& topology);

/// A side of a triangle on which no other triangle is joined; the triangle lies to the left of it. Each side of an
/// obstacle edge is one, and of a step: it may lack something towards a third border.
struct SurfaceBorder {
  Vec3 from, to;
  std::uint32_t triangle = 0;
  std::uint32_t component = 0;  ///< its part (SurfaceParts)
};

/// The borders of a mesh, in the order of triangles and sides.
std::vector<SurfaceBorder> findBorders(const NavigationMesh& mesh, const SurfaceTopology& topology,
                                       const SurfaceParts& parts);

/// The excess of a place for an agent of that height, step and gap (BorderLink::excess).
double excessOf(const BorderLink& link, double height, double step, double gap = 0);

/// The place on each border where the larger of the gap in the plan and of the rise beyond `step` is least, among: the
/// ends of both, where they cross, and, where they run side by side, the middle and where they are level. Nothing where
/// one lies over the other with both walkable sides on the same side.
///
/// Computed in doubles. Both places lie on the borders up to a few units in the last place, so the gap and the rise
/// that are returned exist, and an agent that manages them gets over, up to rounding; another place may need less.
/// Borders touch in a point only by the measure of kTiny of the coordinates: lengths below that are none.
std::optional<BorderLink> linkBetween(const SurfaceBorder& a, const SurfaceBorder& b, double step = 0);

/// The place on a border that is nearest to another place in the plan.
Vec3 nearestPoint(const SurfaceBorder& border, const Vec3& place);
/// The place on a border that lies `step` farther along it than another one, or its end; nothing where that is the
/// same.
std::optional<Vec3> besideOn(const SurfaceBorder& border, const Vec3& place, double step);

/// A link seen from its other border.
BorderLink reversed(const BorderLink& link);

}  // namespace footfall::detail
