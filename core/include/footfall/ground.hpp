// Places, straight ways and many paths over a walkable area, by a PathFinder that is kept.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "footfall/navigation_mesh.hpp"
#include "footfall/path.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

/// The walkable place that is nearest to `p`, in space; the first triangle where two are equally near. Nothing where
/// the mesh has no area. The place lies in its triangle exactly, in the plan; which triangle is nearest is decided in
/// doubles, so that one that is farther by a few units in the last place may be taken. Looks at all triangles (1 ms for
/// 100,000). Throws InputError for a coordinate that is not finite.
std::optional<SurfacePlace> nearestPlace(const PathFinder& finder, const Vec3& p);

/// `count` places, each taken by area: equal areas of the surface (in space) are equally likely. Each lies in its
/// triangle exactly, in the plan. Place i depends on the mesh, on `seed` and on i alone: the same numbers on every
/// machine, and fewer places are the first of more. Throws InputError where the mesh has no area, or an area that no
/// double holds.
std::vector<SurfacePlace> randomPlaces(const PathFinder& finder, std::size_t count, std::uint64_t seed = 0);

/// A straight way over the ground, seen from above.
struct GroundRay {
  SurfacePlace start;  ///< the walkable place at the point that the ray starts from
  /// The last place on the ground: at the target, or on the border that stops the ray. Its distance is that to the
  /// target in the plan.
  SurfacePlace end;
  bool reached = false;   ///< the whole way is walkable
  double planLength = 0;  ///< from start to end
  /// The side of `end.triangle` on which the ray ends, as vertices of the mesh; empty where it ends at a corner or is
  /// not stopped.
  std::optional<std::array<std::uint32_t, 2>> border;
  std::vector<std::uint32_t> triangles;  ///< under the way, in its order
};

/// Walks straight in the plan from the walkable place at `from` (PathFinder::locate() with `reach`) towards the place
/// of `to` in the plan, whose height is not used. It follows the surface over edges, steps and gaps, as paths do, never
/// over drops, and ends at the first border. Nothing where no walkable place is within reach of `from`.
///
/// Which triangles it crosses is decided exactly. A ray passes along a border, and past the end of a thin wall that it
/// touches; it does not pass through a point in which two parts only touch. Where a wall stands along the ray, both of
/// its sides are followed, and the way that goes farthest is the result. From a place on the border of two triangles
/// that are not joined it starts on the one that locate() gives. A ray that ends over a gap ends before it.
/// The end is rounded, and lies in its triangle exactly, in the plan. Throws InputError for a coordinate that is not
/// finite, and Cancelled.
std::optional<GroundRay> castRay(const PathFinder& finder, const Vec3& from, const Vec3& to,
                                 double reach = std::numeric_limits<double>::infinity(),
                                 const RunContext* context = nullptr);

/// The same from a place that is known, such as the end of another ray: it starts in the triangle of `start`, whatever
/// else lies there, so that rays in a row never pass a wall without thickness. Throws InputError for a coordinate that
/// is not finite, a triangle that the mesh does not have, or a place that does not lie in its triangle, and Cancelled.
GroundRay castRayFrom(const PathFinder& finder, const SurfacePlace& start, const Vec3& to,
                      const RunContext* context = nullptr);

/// PathFinder::find() for each pair of a start and a target, in their order, on all threads. Throws InputError for a
/// coordinate that is not finite, and Cancelled.
std::vector<PathResult> findPaths(const PathFinder& finder, std::span<const std::array<Vec3, 2>> pairs,
                                  double reach = std::numeric_limits<double>::infinity(),
                                  const RunContext* context = nullptr);

/// The triangles of one layer as a mesh of one layer, in their order, with the vertices that they use. Links and drops
/// stay where both their triangles are in the layer; connections to other layers become borders. Throws InputError for
/// a layer that is not there.
NavigationMesh layerOf(const NavigationMesh& mesh, std::uint32_t layer);

}  // namespace footfall
