// Dividing one region of the walkable area that lies above itself into pieces that do not.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The minimum number of connections is NP-hard to find (Hillebrand et al. 2016). Here: pieces grow from the lowest
// triangle upwards (their height heuristic), taking what overlaps nothing in the piece; neighbouring pieces that do not
// overlap are merged; and a local search moves triangles across the cuts while that saves connections.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/filters/layers/plan_triangles.hpp"
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

inline constexpr Index kSettled = -2;  ///< in place of a triangle's group

/// The input for subdividing regions; shared by all threads.
struct LayerInput {
  // Null where `knowsAll`:
  const PlanKernel* kernel = nullptr;
  const std::vector<MeshVertex>* vertices = nullptr;
  const PlanTriangles* plan = nullptr;
  /// Triangles in the order of growth, by the height of the lowest corner and then by number, and for each triangle its
  /// place there; only those of regions that are subdivided.
  std::vector<Index> byHeight, rank;
  std::vector<Index> number;  ///< of each triangle among those of its region, where that is subdivided
  IndexLists neighbors;       ///< across edges that are not obstacle edges; only within regions that are subdivided
  IndexLists overlaps;        ///< triangles of the same region that are known to overlap it in the plan
  bool knowsAll = false;      ///< `overlaps` has all that overlap
  /// Triangles of one group, from 0 on, overlap each other nowhere. All that overlap a settled one are in `overlaps`.
  /// -1: neither. May be empty.
  std::vector<Index> group;
};

/// Finds the group of more than half of some triangles; of others, any.
class GroupVote {
 public:
  void add(Index group) {
    if (group < 0) return;
    if (lead_ == 0) main_ = group;
    lead_ += group == main_ ? 1 : -1;
  }
  [[nodiscard]] Index main() const { return main_; }

 private:
  Index main_ = -1, lead_ = 0;
};

/// The work of one call.
struct SearchCounts {
  std::size_t tested = 0;  ///< pairs of triangles that were tested for overlap
  ExactFallbacks fallbacks;
  std::vector<std::array<Index, 2>> found;  ///< those that overlap, each once or more
};

/// Numbers the pieces of the region of `triangles` (ascending; `ranks` has theirs, ascending) from 0 and writes the
/// numbers to `piece[t]`, other elements of which are left alone. Returns for each number the triangle from which the
/// piece grew; a number may have no triangles any more. A smaller number has the lower first triangle.
std::vector<Index> subdivideRegion(const LayerInput& input, std::span<const Index> triangles,
                                   std::span<const Index> ranks, std::vector<Index>& piece, RunContext& context,
                                   SearchCounts& counts);

}  // namespace footfall::detail
