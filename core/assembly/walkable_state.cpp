// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/walkable_state.hpp"

namespace footfall::detail {

std::shared_ptr<const Adjacency> topologyOf(const WalkableState& state, Poll poll) {
  if (state.topology && state.topologyOwner.lock() == state.mesh) return state.topology;
  return std::make_shared<Adjacency>(findEdges(state.mesh->triangles, state.mesh->vertices.size(), poll));
}

}  // namespace footfall::detail
