// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/walkable_state.hpp"

namespace footfall::detail {

// All meshes are made as what can be changed, and are constant for those who share them only.
std::shared_ptr<WalkableMesh> ownMeshOf(const WalkableState& state) {
  if (state.mesh.use_count() == 1) return std::const_pointer_cast<WalkableMesh>(state.mesh);
  return std::make_shared<WalkableMesh>(*state.mesh);
}

std::shared_ptr<const Adjacency> topologyOf(const WalkableState& state, Poll poll) {
  if (state.topology && state.topologyOwner.lock() == state.mesh) return state.topology;
  return std::make_shared<Adjacency>(findEdges(state.mesh->triangles, state.mesh->vertices.size(), poll));
}

}  // namespace footfall::detail
