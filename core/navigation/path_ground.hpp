// The inside of PathFinder: what was prepared for a mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "core/base/poll.hpp"
#include "core/mesh/surface_topology.hpp"
#include "core/navigation/surface_place.hpp"

namespace footfall::detail {

struct PathGround {
  PathGround(std::shared_ptr<const NavigationMesh> givenMesh, const RunContext* context)
      : mesh(std::move(givenMesh)),
        topology(makeSurfaceTopology(*mesh, Poll(context))),
        places(*mesh, topology, Poll(context)) {}
  PathGround(const PathGround&) = delete;
  PathGround& operator=(const PathGround&) = delete;

  std::shared_ptr<const NavigationMesh> mesh;
  SurfaceTopology topology;
  PlaceIndex places;
};

}  // namespace footfall::detail
