// Which sets of triangles of a walkable mesh lie above themselves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/adjacency.hpp"
#include "core/mesh/walkable_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// For each side the triangle beyond it, or -1 where other than exactly one triangle has the same edge on the other
/// side.
std::vector<Index> findTrianglesAcross(const WalkableMesh& mesh, const Adjacency& topology, RunContext& context);

/// For each set whether its triangles cover some place in the plan twice, exactly (cover_sweep.hpp). `setOf` is the set
/// of each triangle, or -1; `across` as findTrianglesAcross() returns it. Sets are decided on all threads.
/// `decisions` (may be null) gets the number of exact decisions.
std::vector<char> findDoubleCovers(const std::vector<Index>& setOf, Index setCount, const std::vector<Index>& across,
                                   const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context,
                                   ExactFallbacks& fallbacks, std::size_t* decisions = nullptr);

/// For each triangle the number of its sheet, or -1 where the sheet covers some place twice. Triangles that are
/// connected over inner sides are one sheet; those that cover no place twice are numbered from 0 on.
std::vector<Index> findFlatSheets(const std::vector<Index>& across, const PlanKernel& kernel, const WalkableMesh& mesh,
                                  RunContext& context, ExactFallbacks& fallbacks, std::size_t* decisions = nullptr);

}  // namespace footfall::detail
