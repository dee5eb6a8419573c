// Builds one conforming mesh from faces and their cuts: triangulates, welds, closes T-joints, joins contacts (model,
// Conforming results).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/assembly/assembly_memory.hpp"
#include "core/assembly/earlier_result.hpp"
#include "core/assembly/walkable_state.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The mesh of all walkable parts. Every vertex that lies exactly on the outline of another part splits it, and equal
/// vertices are one: so parts that meet along a line share its edges, whether it was an edge of both, a T-joint, or a
/// contact. Faces are triangulated on all threads; the result does not depend on their number.
std::shared_ptr<const WalkableMesh> assembleMesh(const WalkableState& state, RunContext& context,
                                                 ExactFallbacks& fallbacks);

// The two halves of assembleMesh().

/// Triangulates what cuts leave of each floor, where they divide it. Takes from `earlier` (may be null) what is not in
/// `changed` (ascending; all floors that differ). `meshes` has one entry for each face; what is there already stays.
void meshFaces(const WalkableState& state, const EarlierResult* earlier, const std::vector<Index>& changed,
               FaceMeshes& meshes, RunContext& context, ExactFallbacks& fallbacks);

/// Joins floors: those that have no mesh are whole. `earlier` and `changed` as above; leaves in `memory` (may be null)
/// what the next run can copy, and drops the meshes otherwise.
std::shared_ptr<const WalkableMesh> joinFaces(const WalkableState& state, const EarlierResult* earlier,
                                              const std::vector<Index>& changed,
                                              const std::shared_ptr<FaceMeshes>& meshes, AssemblyMemory* memory,
                                              RunContext& context, ExactFallbacks& fallbacks);

/// The remainders of cut faces, for display: rounded, not joined.
std::shared_ptr<const NavigationMesh> previewOfFaces(const PlanKernel& kernel, const CutTable& cuts,
                                                     const FaceMeshes& meshes, std::span<const Index> faces,
                                                     const RunContext& context);

/// The state with its mesh assembled (the same state when it is already).
std::shared_ptr<const WalkableState> withMesh(const std::shared_ptr<const WalkableState>& state, RunContext& context,
                                              ExactFallbacks& fallbacks);

}  // namespace footfall::detail
