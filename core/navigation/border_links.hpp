// Borders of a walkable area, and the shortest ways from one to another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/path.hpp"

namespace footfall::detail {

/// A side of a triangle that cannot be crossed; the triangle lies to the left of it. Each side of an obstacle edge is
/// one.
struct BorderEdge {
  Vec3 from, to;
  std::uint32_t triangle = 0;
  std::uint32_t component = 0;
};

/// In the order of triangles and sides.
std::vector<BorderEdge> findBorders(const NavigationMesh& mesh, const SurfaceTopology& topology);

/// The place on each border where the larger of the gap in the plan and the difference in height is least, among:
/// the ends of both, where they cross, and, where they run side by side, the middle and where they are level. Nothing
/// where one lies over the other with both walkable sides on the same side.
std::optional<BorderLink> linkBetween(const BorderEdge& a, const BorderEdge& b);

/// The place on a border that is nearest to another place in the plan.
Vec3 nearestPoint(const BorderEdge& border, const Vec3& place);
/// The place on a border that lies `step` farther along it than another one, or its end; nothing where that is the
/// same.
std::optional<Vec3> besideOn(const BorderEdge& border, const Vec3& place, double step);

/// The same from the other side.
BorderLink reversed(const BorderLink& link);

}  // namespace footfall::detail
