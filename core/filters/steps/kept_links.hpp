// Links of a walkable mesh that a filter makes anew: what is left of their borders stays linked.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/assembly/recall.hpp"
#include "core/assembly/walkable_state.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// A product's link in a mesh with the same numbers.
MeshLink linkOf(const StepLink& link);

/// A product as the mesh with which a generation starts, each of its triangles a face: `faces` has their numbers, and
/// the first vertices of the generation's soup are the product's. `error` is that of scaled source coordinates.
std::shared_ptr<WalkableMesh> floorsOf(const NavigationMesh& product, const SourceMesh& source,
                                       const std::vector<Index>& faces, double error);

/// The state, which has a mesh, with the links of `earlier` where both borders are still there: a filter that takes
/// walkable area away takes its links along. `earlier` is made of points of the state's kernel. Where `isAsked`, the
/// state's clearance is larger than when it was linked, or obstacles moved: what is in the way then parts a link.
StatePtr withLinks(const StatePtr& state, const WalkableMesh& earlier, bool isAsked, RunContext& context,
                   ExactFallbacks& fallbacks);

}  // namespace footfall::detail
