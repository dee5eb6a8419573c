// Triangles that are known to lie above one another, or not to, before any are compared.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/assembly/recall.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/filters/layers/plan_triangles.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

struct KnownOverlaps {
  std::vector<std::array<Index, 2>> pairs;  ///< they overlap in the plan
  bool isAll = false;                       ///< no other triangles do
  std::vector<Index> group;                 ///< as LayerInput has them
};

/// The layers of an earlier result prove that triangles that are still there do not overlap; pairs that overlapped
/// still do; other triangles are compared with all. Nothing is known where `before` is null, left none, or has little
/// in common with the mesh.
KnownOverlaps knownFrom(const StatePtr& before, const PlanKernel& kernel, const WalkableMesh& mesh,
                        const PlanTriangles& plan, RunContext& context, ExactFallbacks& fallbacks);

/// Decides for each region whether it lies above itself: by what is known, else by its outline (double_cover.hpp).
/// `kernel` may be null where all is known.
std::vector<char> findRegionsAboveThemselves(const std::vector<Index>& regionOf, Index regionCount,
                                             const KnownOverlaps& known, const PlanKernel* kernel,
                                             const WalkableMesh& mesh, const Adjacency& topology, RunContext& context,
                                             ExactFallbacks& fallbacks);

/// The layer that LayerSubdivisionFilter gives each triangle. `overlaps` are all pairs of triangles that overlap in the
/// plan, each once, in any order; only `z` of vertices is read.
std::vector<std::uint32_t> layersOf(const WalkableMesh& mesh, const Adjacency& topology,
                                    std::vector<std::array<Index, 2>> overlaps, RunContext& context);

}  // namespace footfall::detail
