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
  /// For each source triangle: it takes part as a floor (its cuts say which part of it).
  std::vector<char> walkable;
  /// For each source triangle: taken out of the environment altogether (DegeneracyFilter).
  std::vector<char> removed;
  /// For each source triangle, or empty before the first clearance filter.
  std::shared_ptr<const CutTable> cuts;
  /// The largest height that a clearance filter asked for, or one that stands for it; 0 before the first.
  double clearance = 0;
  /// The largest clearance exactly as it was asked for.
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
  /// How the last clearance filter made its mesh, which later runs reuse; null unless the run was asked to keep it.
  std::shared_ptr<const AssemblyMemory> memory;
  /// What the last SimplificationFilter was made of, which later runs reuse; or null.
  std::shared_ptr<const SimplifierMemory> simplifierMemory;
  /// The same of the last StepFilter.
  std::shared_ptr<const StepMemory> stepMemory;
  /// The same of the last RadiusFilter.
  std::shared_ptr<const RadiusMemory> radiusMemory;
  /// Pairs of triangles that the last LayerSubdivisionFilter found above one another; null unless it was to keep them.
  std::shared_ptr<const std::vector<std::array<Index, 2>>> overlaps;
};

/// The mesh of a state that nobody needs any more, to be changed: itself where no other state has it, else a copy.
std::shared_ptr<WalkableMesh> ownMeshOf(const WalkableState& state);

/// The topology of the state's mesh: what an earlier filter found for the same mesh, else found now.
std::shared_ptr<const Adjacency> topologyOf(const WalkableState& state, Poll poll = {});

}  // namespace footfall::detail
