// The product but for its layers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/filters/rounding/known_places.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"

namespace footfall::detail {

/// A rounded mesh that is in order, with its edges.
struct SettledMesh {
  RoundedMesh mesh;  ///< without layers: `origins` give them
  Adjacency topology;
  std::vector<std::array<Vec3, 2>> moved;  ///< places that repairs moved to others, in that order
  std::vector<std::uint32_t> origins;      ///< triangle of the given mesh that each triangle is (a part of)
};

/// The part of makeNavigationMesh() that depends on a state's mesh and edges only, not on layers and links.
struct SettledProduct {
  std::shared_ptr<const RoundedPlaces> rounded;
  SettledMesh settled;
};

/// Starts early, so that it runs while the layers are found. The state has a mesh, whose edges `topology` has.
SettledProduct settleProduct(const WalkableState& state, const Adjacency& topology, const KnownPlaces& known,
                             RunContext& context);

/// The rest. The mesh of the state is that which was given above, but for its layers.
std::shared_ptr<const NavigationMesh> makeNavigationMesh(const WalkableState& state, SettledProduct product,
                                                         const RunContext& context);

}  // namespace footfall::detail
