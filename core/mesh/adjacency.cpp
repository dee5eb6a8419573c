// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/adjacency.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/disjoint_sets.hpp"

namespace footfall::detail {
namespace {

// Vertices whose edges one task sorts; a mesh with fewer is done by one thread.
constexpr Index kVerticesPerTask = 4096;
constexpr Index kPolledTriangles = 1 << 16;
// Triangles that one thread sorts by their vertices. Of more, each thread takes a part of the vertices and looks at all
// triangles; with more threads than this, looking is all that they would do.
constexpr Index kFewTriangles = 4096;
constexpr Index kMostParts = 8;

/// A side among those with the same smaller vertex: by the larger vertex, then by number.
using Entry = std::uint64_t;

Index largerOf(Entry entry) { return static_cast<Index>(entry >> 32); }

// Most vertices have a handful of sides.
void sortEntries(Entry* begin, Entry* end) {
  if (end - begin > 32) {
    std::sort(begin, end);
    return;
  }
  for (Entry* i = begin; i < end; ++i) {
    const Entry entry = *i;
    Entry* j = i;
    for (; j > begin && entry < j[-1]; --j) *j = j[-1];
    *j = entry;
  }
}

template <class Work>
void forVertices(Index count, Poll poll, Work work) {
  const auto polled = [&](Index first, Index last) {
    poll();
    work(first, last);
  };
  if (count == 0) return;
  if (count <= kVerticesPerTask) return polled(0, count);
  tbb::parallel_for(tbb::blocked_range<Index>(0, (count + kVerticesPerTask - 1) / kVerticesPerTask, 1),
                    [&](const auto& range) {
                      for (Index block = range.begin(); block != range.end(); ++block)
                        polled(block * kVerticesPerTask, std::min((block + 1) * kVerticesPerTask, count));
                    });
}

}  // namespace

// A counting sort by the smaller vertex, then each vertex's few sides by the larger one.
Adjacency findEdges(const TriangleCorners& triangles, std::size_t vertexCount, Poll poll) {
  const Index count = triangles.size(), vertices = static_cast<Index>(vertexCount);
  std::vector<Index> bucket(vertexCount + 1, 0);
  // Each part looks at all triangles, and deals with the sides of its own vertices.
  const Index parts = count < kFewTriangles ? 1 : std::min<Index>(tbb::this_task_arena::max_concurrency(), kMostParts);
  const auto forSides = [&](const auto& visit) {
    tbb::parallel_for(Index{0}, parts, [&](Index part) {
      const auto first = static_cast<Index>(std::int64_t{vertices} * part / parts);
      const auto last = static_cast<Index>(std::int64_t{vertices} * (part + 1) / parts);
      for (Index t = 0; t < count; ++t) {
        if (t % kPolledTriangles == 0) poll();
        const Index* c = triangles[t];
        for (int k = 0; k < 3; ++k) {
          const Index v = c[k], w = c[k == 2 ? 0 : k + 1], smaller = std::min(v, w);
          if (first <= smaller && smaller < last) visit(smaller, std::max(v, w), 3 * t + k);
        }
      }
    });
  };
  forSides([&](Index smaller, Index, Index) { ++bucket[smaller]; });
  Index sum = 0;
  for (Index& size : bucket) sum += std::exchange(size, sum);
  std::vector<Entry> entries(static_cast<std::size_t>(count) * 3);
  forSides([&](Index smaller, Index larger, Index side) {
    entries[bucket[smaller]++] = static_cast<Entry>(larger) << 32 | static_cast<Entry>(side);
  });

  // Now bucket[v] is where the sides of v end.
  const auto beginOfBucket = [&](Index v) { return v == 0 ? 0 : bucket[v - 1]; };
  Adjacency adjacency;
  adjacency.sides.resize(entries.size());
  std::vector<Index> edgesBefore((vertexCount + kVerticesPerTask - 1) / kVerticesPerTask + 1, 0);
  const auto isFirst = [&](Index i, Index begin) {
    return i == begin || largerOf(entries[i]) != largerOf(entries[i - 1]);
  };
  forVertices(vertices, poll, [&](Index first, Index last) {
    Index edges = 0;
    for (Index v = first; v < last; ++v) {
      const Index begin = beginOfBucket(v);
      sortEntries(entries.data() + begin, entries.data() + bucket[v]);
      for (Index i = begin; i < bucket[v]; ++i) {
        adjacency.sides[i] = static_cast<Index>(entries[i] & 0xFFFFFFFF);
        edges += static_cast<Index>(isFirst(i, begin));
      }
    }
    edgesBefore[first / kVerticesPerTask + 1] = edges;
  });
  for (std::size_t i = 1; i < edgesBefore.size(); ++i) edgesBefore[i] += edgesBefore[i - 1];
  adjacency.first.resize(static_cast<std::size_t>(edgesBefore.back()) + 1);
  forVertices(vertices, poll, [&](Index first, Index last) {
    Index edge = edgesBefore[first / kVerticesPerTask];
    for (Index v = first; v < last; ++v) {
      const Index begin = beginOfBucket(v);
      for (Index i = begin; i < bucket[v]; ++i)
        if (isFirst(i, begin)) adjacency.first[edge++] = i;
    }
  });
  adjacency.first.back() = static_cast<Index>(entries.size());
  return adjacency;
}

Adjacency edgesOfSome(const Adjacency& all, const std::vector<Index>& renumbered, Poll poll) {
  Adjacency some;
  some.sides.reserve(all.sides.size());
  some.first.reserve(all.first.size());
  for (Index e = 0; e < all.edgeCount(); ++e) {
    if (e % kPolledTriangles == 0) poll();
    const auto first = static_cast<Index>(some.sides.size());
    for (const Index side : all.sidesOf(e))
      if (const Index t = renumbered[side / 3]; t >= 0) some.sides.push_back(3 * t + side % 3);
    if (static_cast<Index>(some.sides.size()) > first) some.first.push_back(first);
  }
  some.first.push_back(static_cast<Index>(some.sides.size()));
  return some;
}

std::vector<Index> findParts(const TriangleCorners& triangles, std::size_t vertexCount, Index& partCount, Poll poll) {
  const Adjacency adjacency = findEdges(triangles, vertexCount, poll);
  DisjointSets sets(static_cast<std::size_t>(triangles.size()));
  for (Index e = 0; e < adjacency.edgeCount(); ++e) {
    const auto sides = adjacency.sidesOf(e);
    for (const Index side : sides.subspan(1)) sets.unite(sides[0] / 3, side / 3);
  }
  return sets.numbers(partCount);
}

}  // namespace footfall::detail
