// Borders of a walkable area, and the shortest ways from one to another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"

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

enum class LinkKind {
  Open,        ///< nothing stands between: a step, a gap, or both
  Obstacle,    ///< something lower than the agent stands between
  LowCeiling,  ///< something hangs over the way, too low
  Wall,        ///< something as high as the agent stands between
  Touch        ///< both meet in one point, through which nobody fits
};

/// Where one border is near another one, and what an agent would have to overcome there. Lengths are distances in
/// doubles (square roots), off by a few units in the last place of the coordinates.
struct BorderLink {
  Vec3 from, to;
  std::uint32_t fromComponent = 0, toComponent = 0;
  double gap = 0;   ///< between the two places in the plan
  double rise = 0;  ///< from the first to the second, upwards
  LinkKind kind = LinkKind::Open;
  double obstacle = 0;     ///< LinkKind::Obstacle: its height over the lower place
  double headroom = 0;     ///< LinkKind::LowCeiling: the free height over the higher place
  bool isInterval = true;  ///< the borders face each other, and do not only meet in a point

  /// The larger of the gap and the height that is climbed, walls left out.
  [[nodiscard]] double size() const;
  /// An agent of any step and gap does not get over it.
  [[nodiscard]] bool isBlocked() const { return kind != LinkKind::Open && kind != LinkKind::Obstacle; }
};

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
