// Rounded places of vertices, kept from run to run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/assembly/recall.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/mesh/walkable_mesh.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The result of roundVertices() for the mesh of a state.
struct RoundedPlaces {
  std::vector<Vec3> places;
  std::vector<char> exact;
};

/// An earlier state whose mesh was rounded; both may be null.
struct KnownPlaces {
  StatePtr state;
  std::shared_ptr<const RoundedPlaces> rounded;
};

/// roundVertices() with results from `known` for vertices that have not changed.
RoundedPlaces roundVertices(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices, const KnownPlaces& known,
                            RunContext& context);

/// The navigation mesh of a state; `rounded` receives the places that it was made of.
std::shared_ptr<const NavigationMesh> makeNavigationMesh(const StatePtr& state, const KnownPlaces& known,
                                                         std::shared_ptr<const RoundedPlaces>& rounded,
                                                         RunContext& context);

}  // namespace footfall::detail
