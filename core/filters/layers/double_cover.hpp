// Finds sets of triangles of a walkable mesh that lie above themselves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/adjacency.hpp"
#include "core/mesh/walkable_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The triangle beyond each side, or -1 unless exactly one triangle has the same edge on the other side.
std::vector<Index> findTrianglesAcross(const WalkableMesh& mesh, const Adjacency& topology, RunContext& context);

/// Decides for each set whether its triangles cover some place in the plan twice, exactly (cover_sweep.hpp). `setOf` is
/// the set of each triangle, or -1; `across` is the result of findTrianglesAcross(). Sets are decided on all threads.
/// `decisions` (may be null) receives the number of exact decisions.
std::vector<char> findDoubleCovers(const std::vector<Index>& setOf, Index setCount, const std::vector<Index>& across,
                                   const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context,
                                   ExactFallbacks& fallbacks, std::size_t* decisions = nullptr);

/// The number of each triangle's sheet, or -1 where the sheet covers some place twice. Triangles that are connected
/// over inner sides are one sheet; sheets that cover no place twice are numbered from 0 on.
std::vector<Index> findFlatSheets(const std::vector<Index>& across, const PlanKernel& kernel, const WalkableMesh& mesh,
                                  RunContext& context, ExactFallbacks& fallbacks);

}  // namespace footfall::detail
