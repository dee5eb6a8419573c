// Finding the place on a navigation mesh that a point means.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/mesh/surface_relation.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/path.hpp"

namespace footfall::detail {

/// Index over a mesh and its topology, which must outlive it. Thread-safe once made.
class PlaceIndex {
 public:
  PlaceIndex(const NavigationMesh& mesh, const SurfaceTopology& topology, Poll poll = {});
  /// An index that gives the same answers, with the tree of an earlier one where few triangles changed.
  PlaceIndex(const NavigationMesh& mesh, const SurfaceTopology& topology, const PlaceIndex& before,
             const SurfaceRelation& relation, Poll poll = {});

  /// The walkable place straight above or below `p` that is nearest to it, when it is no farther than `reach`; the
  /// first triangle where two are equally near. Which triangles lie there is decided exactly.
  [[nodiscard]] std::optional<SurfacePlace> locate(const Vec3& p, double reach) const;

  /// The nearest place in space; of those components for which `components` is not 0, where it is given. Nothing when
  /// there is no such triangle. Looks at all triangles (1 ms for 100,000).
  [[nodiscard]] std::optional<SurfacePlace> nearest(const Vec3& p, const std::vector<char>* components = nullptr) const;

  /// The place in a triangle that is nearest to `p`, or as good as nearest where rounding left it outside.
  [[nodiscard]] SurfacePlace nearestInside(const Vec3& p, std::uint32_t triangle) const;

  /// The place in a triangle at `p` in the plan, whose height is not used; moved into the triangle where rounding left
  /// it outside. Its distance is 0.
  [[nodiscard]] SurfacePlace placeInside(const Vec3& p, std::uint32_t triangle) const;

 private:
  void build(Poll poll);
  /// Calls visit(triangle) for each triangle that may lie over or under a place, and perhaps for others.
  template <class Visit>
  void visitAt(const Vec3& p, const Visit& visit) const;

  const NavigationMesh& mesh_;
  const SurfaceTopology& topology_;
  std::shared_ptr<const TriangleTree> tree_;
  /// The number of each triangle of the tree in the mesh now, or kNoElement; empty where no number changed.
  std::vector<std::uint32_t> numberNow_;
  TriangleTree added_;  ///< triangles that are not in the tree
};

}  // namespace footfall::detail
