// Links of a walkable mesh that a filter makes anew: the remaining parts of their borders stay linked.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/assembly/recall.hpp"
#include "core/assembly/walkable_state.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The link of a product in a mesh with the same numbers.
MeshLink linkOf(const StepLink& link);

/// Makes the mesh with which a generation starts from a product, each of whose triangles is a face. `faces` has the
/// numbers of the faces, and the first vertices of the generation's soup are the product's. `error` is that of scaled
/// source coordinates.
std::shared_ptr<WalkableMesh> floorsOf(const NavigationMesh& product, const SourceMesh& source,
                                       const std::vector<Index>& faces, double error);

/// Returns the state, which has a mesh, with the links of `earlier` whose borders both still exist; a filter that
/// removes walkable area removes its links as well. `earlier` consists of points of the state's kernel. `isAsked` is
/// true where the state's clearance is larger than when it was linked, or where obstacles moved; new obstacles then
/// divide links.
StatePtr withLinks(const StatePtr& state, const WalkableMesh& earlier, bool isAsked, RunContext& context,
                   ExactFallbacks& fallbacks);

}  // namespace footfall::detail
