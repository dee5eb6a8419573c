// The inside of PathFinder: what was prepared for a mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "core/base/poll.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "core/mesh/surface_relation.hpp"
#include "core/mesh/surface_topology.hpp"
#include "core/navigation/surface_place.hpp"

namespace footfall::detail {

/// The mesh with bridges over its gaps: itself where it has none.
inline std::shared_ptr<const NavigationMesh> bridgedSurface(const std::shared_ptr<const NavigationMesh>& mesh) {
  if (std::ranges::find(mesh->links, StepKind::Gap, &StepLink::kind) == mesh->links.end()) return mesh;
  return std::make_shared<const NavigationMesh>(withBridges(*mesh));
}

struct PathGround {
  PathGround(std::shared_ptr<const NavigationMesh> givenMesh, const RunContext* context)
      : mesh(std::move(givenMesh)),
        surface(bridgedSurface(mesh)),
        topology(makeSurfaceTopology(*surface, Poll(context))),
        places(*mesh, topology, Poll(context)) {}
  /// The same as without `before`, which takes longer.
  PathGround(std::shared_ptr<const NavigationMesh> givenMesh, const PathGround& before, const RunContext* context)
      : PathGround(std::move(givenMesh), before, SurfaceRelation(), context) {}
  PathGround(const PathGround&) = delete;
  PathGround& operator=(const PathGround&) = delete;

  std::shared_ptr<const NavigationMesh> mesh;
  std::shared_ptr<const NavigationMesh> surface;  ///< the mesh with bridges over its gaps
  SurfaceTopology topology;                       ///< topology of the surface
  PlaceIndex places;

 private:
  PathGround(std::shared_ptr<const NavigationMesh> givenMesh, const PathGround& before, SurfaceRelation relation,
             const RunContext* context)
      : mesh(std::move(givenMesh)),
        surface(bridgedSurface(mesh)),
        topology(follow(*surface, before, relation, Poll(context))),
        places(*mesh, topology, before.places, relation, Poll(context)) {}

  static SurfaceTopology follow(const NavigationMesh& surface, const PathGround& before, SurfaceRelation& relation,
                                Poll poll) {
    relation = relateSurfaces(*before.surface, surface, poll);
    return followSurfaceTopology(surface, before.topology, *before.surface, relation, poll);
  }
};

}  // namespace footfall::detail
