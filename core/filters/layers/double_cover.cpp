// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/double_cover.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/layers/cover_sweep.hpp"
#include "core/filters/layers/plan_order.hpp"

namespace footfall::detail {
namespace {

constexpr Index kEdgesPerTask = 2048;
constexpr std::size_t kSetsPerTask = 16;

/// The sides of the outlines of sets that may lie above themselves. A triangle does not, nor do two on either side of
/// an edge.
class Outlines {
 public:
  struct Sides {
    std::vector<CoverSweep::Side> sides;  ///< by set, and within one by the places of their left ends
    std::vector<Index> first;             ///< first side of each set, and the end
  };

  Outlines(const std::vector<Index>& setOf, Index setCount, const std::vector<Index>& across, const WalkableMesh& mesh)
      : setOf_(setOf), setCount_(setCount), corners_(mesh.triangles), isThere_(mesh.vertices.size(), 0) {
    std::vector<Index> sizes(setCount, 0), pairs(setCount, 0);
    const auto isInner = [&](Index side) { return across[side] >= 0 && setOf[across[side]] == setOf[side / 3]; };
    for (Index t = 0; t < static_cast<Index>(setOf.size()); ++t) {
      if (setOf[t] < 0) continue;
      ++sizes[setOf[t]];
      for (Index side = 3 * t; side < 3 * t + 3; ++side) pairs[setOf[t]] += static_cast<Index>(isInner(side));
    }
    for (Index side = 0; side < static_cast<Index>(across.size()); ++side) {
      const Index set = setOf[side / 3];
      if (set < 0 || isInner(side) || sizes[set] < 2 || (sizes[set] == 2 && pairs[set] > 0)) continue;
      sides_.push_back(side);
      for (const Index end : {corners_.beginOf(side), corners_.endOf(side)}) {
        if (isThere_[end] == 0) vertices_.push_back(end);
        isThere_[end] = 1;
      }
    }
  }

  [[nodiscard]] const std::vector<Index>& vertices() const { return vertices_; }

  [[nodiscard]] Sides sidesBySet(const PlanOrder& order) const {
    const std::vector<Index> byPlace = sorted(sides_, static_cast<Index>(order.vertexAt.size()), [&](Index side) {
      return std::min(order.placeOf[corners_.beginOf(side)], order.placeOf[corners_.endOf(side)]);
    });
    Sides result;
    const std::vector<Index> bySet = sorted(byPlace, setCount_, [&](Index side) { return setOf_[side / 3]; });
    result.first.assign(setCount_ + 1, 0);
    for (const Index side : bySet) {
      result.sides.push_back({corners_.beginOf(side), corners_.endOf(side)});
      ++result.first[setOf_[side / 3] + 1];
    }
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    return result;
  }

 private:
  /// Sorts by counting; equal keys keep their order.
  template <class KeyOf>
  static std::vector<Index> sorted(const std::vector<Index>& items, Index keys, const KeyOf& keyOf) {
    std::vector<Index> next(keys + 1, 0), result(items.size());
    for (const Index item : items) ++next[keyOf(item) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const Index item : items) result[next[keyOf(item)]++] = item;
    return result;
  }

  const std::vector<Index>& setOf_;
  Index setCount_;
  TriangleCorners corners_;
  std::vector<char> isThere_;
  std::vector<Index> sides_, vertices_;
};

}  // namespace

std::vector<Index> findTrianglesAcross(const WalkableMesh& mesh, const Adjacency& topology, RunContext& context) {
  const TriangleCorners corners(mesh.triangles);
  std::vector<Index> across(mesh.triangles.size() * 3, -1);
  parallelRanges(topology.edgeCount(), kEdgesPerTask, [&](const auto& range) {
    context.checkCancelled();
    for (Index e = range.begin(); e != range.end(); ++e) {
      const auto sides = topology.sidesOf(e);
      if (sides.size() != 2 || corners.beginOf(sides[0]) == corners.beginOf(sides[1])) continue;
      across[sides[0]] = sides[1] / 3;
      across[sides[1]] = sides[0] / 3;
    }
  });
  return across;
}

std::vector<char> findDoubleCovers(const std::vector<Index>& setOf, Index setCount, const std::vector<Index>& across,
                                   const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context,
                                   ExactFallbacks& fallbacks, std::size_t* decisions) {
  const Outlines outlines(setOf, setCount, across, mesh);
  std::size_t compared = 0;
  const PlanOrder order = findPlanOrder(outlines.vertices(), kernel, mesh, context, fallbacks, compared);
  context.checkCancelled();
  const Outlines::Sides all = outlines.sidesBySet(order);
  context.checkCancelled();

  PerThread<CoverSweep> sweeps([&] { return CoverSweep(kernel, mesh.vertices, order); });
  std::vector<char> covers(setCount, 0);
  parallelRanges(setCount, kSetsPerTask, [&](const auto& range) {
    CoverSweep& sweep = sweeps.local();
    for (Index set = range.begin(); set != range.end(); ++set) {
      const std::span<const CoverSweep::Side> own(all.sides.data() + all.first[set],
                                                  all.sides.data() + all.first[set + 1]);
      if (!own.empty()) covers[set] = static_cast<char>(sweep.coversTwice(own, context));
    }
  });
  if (decisions != nullptr) *decisions += compared;
  for (const CoverSweep& sweep : sweeps) {
    fallbacks += sweep.fallbacks();
    if (decisions != nullptr) *decisions += sweep.decisions();
  }
  return covers;
}

std::vector<Index> findFlatSheets(const std::vector<Index>& across, const PlanKernel& kernel, const WalkableMesh& mesh,
                                  RunContext& context, ExactFallbacks& fallbacks) {
  DisjointSets sets(mesh.triangles.size());
  for (Index side = 0; side < static_cast<Index>(across.size()); ++side)
    if (across[side] > side / 3) sets.unite(side / 3, across[side]);
  Index count = 0;
  std::vector<Index> sheets = sets.numbers(count);
  const std::vector<char> covers = findDoubleCovers(sheets, count, across, kernel, mesh, context, fallbacks);
  std::vector<Index> numbers(count, -1);
  Index next = 0;
  for (Index sheet = 0; sheet < count; ++sheet)
    if (covers[sheet] == 0) numbers[sheet] = next++;
  for (Index& sheet : sheets) sheet = numbers[sheet];
  return sheets;
}

}  // namespace footfall::detail
