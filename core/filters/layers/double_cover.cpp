// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/double_cover.hpp"

#include <numeric>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/layers/cover_sweep.hpp"

namespace footfall::detail {
namespace {

constexpr Index kEdgesPerTask = 2048;
constexpr std::size_t kSetsPerTask = 16;

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
  const auto sideCount = static_cast<Index>(across.size());
  const auto isOutline = [&](Index side) {
    const Index set = setOf[side / 3];
    return set >= 0 && (across[side] < 0 || setOf[across[side]] != set);
  };
  std::vector<Index> first(setCount + 1, 0), sizes(setCount, 0);
  for (const Index set : setOf)
    if (set >= 0) ++sizes[set];
  for (Index side = 0; side < sideCount; ++side)
    if (isOutline(side)) ++first[setOf[side / 3] + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> sides(first.back()), next(first.begin(), first.end() - 1);
  for (Index side = 0; side < sideCount; ++side)
    if (isOutline(side)) sides[next[setOf[side / 3]]++] = side;
  context.checkCancelled();

  const TriangleCorners corners(mesh.triangles);
  PerThread<CoverSweep> sweeps([&] { return CoverSweep(kernel, mesh.vertices); });
  std::vector<char> covers(setCount, 0);
  parallelRanges(setCount, kSetsPerTask, [&](const auto& range) {
    CoverSweep& sweep = sweeps.local();
    std::vector<CoverSweep::Side> outline;
    for (Index set = range.begin(); set != range.end(); ++set) {
      if (sizes[set] < 2) continue;
      outline.clear();
      for (Index i = first[set]; i < first[set + 1]; ++i)
        outline.push_back({corners.beginOf(sides[i]), corners.endOf(sides[i])});
      covers[set] = static_cast<char>(sweep.coversTwice(outline, context));
    }
  });
  for (const CoverSweep& sweep : sweeps) {
    fallbacks += sweep.fallbacks();
    if (decisions != nullptr) *decisions += sweep.decisions();
  }
  return covers;
}

std::vector<Index> findFlatSheets(const std::vector<Index>& across, const PlanKernel& kernel, const WalkableMesh& mesh,
                                  RunContext& context, ExactFallbacks& fallbacks, std::size_t* decisions) {
  DisjointSets sets(mesh.triangles.size());
  for (Index side = 0; side < static_cast<Index>(across.size()); ++side)
    if (across[side] > side / 3) sets.unite(side / 3, across[side]);
  Index count = 0;
  std::vector<Index> sheets = sets.numbers(count);
  const std::vector<char> covers = findDoubleCovers(sheets, count, across, kernel, mesh, context, fallbacks, decisions);
  std::vector<Index> numbers(count, -1);
  Index next = 0;
  for (Index sheet = 0; sheet < count; ++sheet)
    if (covers[sheet] == 0) numbers[sheet] = next++;
  for (Index& sheet : sheets) sheet = numbers[sheet];
  return sheets;
}

}  // namespace footfall::detail
