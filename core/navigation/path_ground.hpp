// The inside of PathFinder: what was prepared for a mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "core/base/poll.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "core/mesh/surface_topology.hpp"
#include "core/navigation/surface_place.hpp"

namespace footfall::detail {

struct PathGround {
  PathGround(std::shared_ptr<const NavigationMesh> givenMesh, const RunContext* context)
      : mesh(std::move(givenMesh)),
        surface(std::ranges::find(mesh->links, StepKind::Gap, &StepLink::kind) == mesh->links.end()
                    ? mesh
                    : std::make_shared<const NavigationMesh>(withBridges(*mesh))),
        topology(makeSurfaceTopology(*surface, Poll(context))),
        places(*mesh, topology, Poll(context)) {}
  PathGround(const PathGround&) = delete;
  PathGround& operator=(const PathGround&) = delete;

  std::shared_ptr<const NavigationMesh> mesh;
  std::shared_ptr<const NavigationMesh> surface;  ///< the mesh with bridges over its gaps
  SurfaceTopology topology;                       ///< topology of the surface
  PlaceIndex places;
};

}  // namespace footfall::detail
