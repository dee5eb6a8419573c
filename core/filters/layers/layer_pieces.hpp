// Dividing one region of the walkable area that lies above itself into pieces that do not.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The minimum number of connections is NP-hard to find (Hillebrand et al. 2016). Here: pieces grow from the lowest
// triangle upwards (their height heuristic), taking what overlaps nothing in the piece; neighbouring pieces that do not
// overlap are merged; and a local search moves triangles across the cuts while that saves connections.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/walkable_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The list of others for each triangle (or piece), one after another.
struct IndexLists {
  std::vector<Index> first;  ///< start of each list, and the end
  std::vector<Index> items;

  [[nodiscard]] std::span<const Index> operator[](Index t) const {
    return {items.data() + first[t], static_cast<std::size_t>(first[t + 1] - first[t])};
  }
};

/// The input for subdividing a region; shared by all threads.
struct LayerInput {
  /// Triangles in the order of growth, by the height of the lowest corner and then by number, and for each triangle its
  /// place there; only those of regions that are subdivided.
  std::vector<Index> byHeight, rank;
  std::vector<Index> number;  ///< of each triangle among those of its region, where that is subdivided without pairs
  IndexLists neighbors;       ///< across edges that are not obstacle edges; only within regions that are subdivided
  IndexLists overlaps;  ///< triangles of the same region that overlap it in the plan; empty where pairs are unknown
};

/// Numbers the pieces of the region of `triangles` (ascending; `ranks` has theirs, ascending) from 0 and writes the
/// numbers to `piece[t]`, other elements of which are left alone. Returns for each number the triangle from which the
/// piece grew; a number may have no triangles any more. A smaller number has the lower first triangle.
std::vector<Index> subdivideRegion(const LayerInput& input, std::span<const Index> triangles,
                                   std::span<const Index> ranks, std::vector<Index>& piece, RunContext& context);

/// The work of one call where pairs are unknown.
struct SearchCounts {
  std::size_t tested = 0;  ///< pairs of triangles that were tested for overlap
  ExactFallbacks fallbacks;
};

/// The same where pairs are unknown.
std::vector<Index> subdivideRegion(const LayerInput& input, std::span<const Index> triangles,
                                   std::span<const Index> ranks, const PlanKernel& kernel, const WalkableMesh& mesh,
                                   std::vector<Index>& piece, RunContext& context, SearchCounts& counts);

}  // namespace footfall::detail
