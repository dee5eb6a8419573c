// The state between filters: which source triangles are floors, what obstacles cut out of them, and the mesh of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/face_cuts.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

struct AssemblyMemory;    // core/assembly/assembly_memory.hpp
struct SimplifierMemory;  // core/filters/simplification/simplifier.hpp
struct RadiusMemory;      // core/filters/radius/radius_memory.hpp
struct StepMemory;        // core/filters/steps/step_memory.hpp

struct WalkableState {
  std::shared_ptr<const Environment> environment;
  std::shared_ptr<const PlanKernel> kernel;
  /// One flag per source triangle: it takes part as a floor (its cuts give the part).
  std::vector<char> walkable;
  /// One flag per source triangle: DegeneracyFilter took it out of the environment.
  std::vector<char> removed;
  /// One entry per source triangle; empty before the first clearance filter.
  std::shared_ptr<const CutTable> cuts;
  /// The largest height of the clearance filters so far, or one that stands for it; 0 before the first.
  double clearance = 0;
  /// The largest clearance, exactly as it was given.
  double agentHeight = 0;
  /// The largest step that a StepFilter allowed; 0 before the first.
  double step = 0;
  /// The mesh of walkable parts; null until a filter needed it.
  std::shared_ptr<const WalkableMesh> mesh;
  /// The edges of `topologyOwner`, when a filter found them; of use while that is still `mesh` (topologyOf()).
  std::shared_ptr<const Adjacency> topology;
  std::weak_ptr<const WalkableMesh> topologyOwner;
  /// The mesh's triangles may span several coplanar source triangles (SimplificationFilter).
  bool simplified = false;
  /// Pieces of regions that filters took away since the cuts were made: obstacles still, but no floor any more.
  std::shared_ptr<const WalkableMesh> dropped;
  /// The data from which the last clearance filter made its mesh, which later runs reuse; null unless the run keeps it.
  std::shared_ptr<const AssemblyMemory> memory;
  /// The data from which the last SimplificationFilter made its mesh, which later runs reuse; or null.
  std::shared_ptr<const SimplifierMemory> simplifierMemory;
  /// The same of the last StepFilter.
  std::shared_ptr<const StepMemory> stepMemory;
  /// The same of the last RadiusFilter.
  std::shared_ptr<const RadiusMemory> radiusMemory;
  /// Pairs of triangles above one another that the last LayerSubdivisionFilter met; null unless it was to keep them.
  std::shared_ptr<const std::vector<std::array<Index, 2>>> overlaps;
};

/// The mesh of a state that is no longer needed, for changing: the mesh itself where no other state has it, else a
/// copy.
std::shared_ptr<WalkableMesh> ownMeshOf(const WalkableState& state);

/// The topology of the state's mesh: what an earlier filter found for the same mesh, else found now.
std::shared_ptr<const Adjacency> topologyOf(const WalkableState& state, Poll poll = {});

}  // namespace footfall::detail
