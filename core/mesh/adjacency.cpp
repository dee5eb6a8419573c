// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/adjacency.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/base/unfilled_array.hpp"
#include "core/base/worker_arena.hpp"

namespace footfall::detail {
namespace {

// Vertices whose edges one task sorts; a mesh with fewer is done by one thread.
constexpr Index kVerticesPerTask = 1024;
constexpr Index kPolledTriangles = 1 << 16;
// The number of triangles that one thread sorts by their vertices. With more triangles, each thread takes a part of the
// vertices and scans the blocks of triangles that may have some of them: few where vertices are numbered by their first
// use, all at worst. With more threads than this, they would only scan.
constexpr Index kFewTriangles = 4096;
constexpr Index kMostParts = 16;
constexpr Index kTrianglesPerBlock = 1024;

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
  parallelRanges((count + kVerticesPerTask - 1) / kVerticesPerTask, 1, [&](const auto& range) {
    for (Index block = range.begin(); block != range.end(); ++block)
      polled(block * kVerticesPerTask, std::min((block + 1) * kVerticesPerTask, count));
  });
}

/// The smaller vertices of the edges of a block of triangles lie between these.
struct VertexRange {
  Index low = std::numeric_limits<Index>::max(), high = -1;
};

std::vector<VertexRange> rangesOf(const TriangleCorners& triangles, Poll poll) {
  const Index count = triangles.size();
  std::vector<VertexRange> ranges((count + kTrianglesPerBlock - 1) / kTrianglesPerBlock);
  parallelFor(ranges.size(), [&](std::size_t block) {
    poll();
    VertexRange range;
    const Index first = static_cast<Index>(block) * kTrianglesPerBlock;
    for (Index t = first; t < std::min(first + kTrianglesPerBlock, count); ++t)
      for (int k = 0; k < 3; ++k) {
        range.low = std::min(range.low, triangles[t][k]);
        range.high = std::max(range.high, triangles[t][k]);
      }
    ranges[block] = range;
  });
  return ranges;
}

}  // namespace

// A counting sort by the smaller vertex, then each vertex's few sides by the larger one.
Adjacency findEdges(const TriangleCorners& triangles, std::size_t vertexCount, Poll poll) {
  const Index count = triangles.size(), vertices = static_cast<Index>(vertexCount);
  std::vector<Index> bucket(vertexCount + 1, 0);
  // Each part deals with the sides of its own vertices.
  const std::vector<VertexRange> ranges = rangesOf(triangles, poll);
  const Index parts = count < kFewTriangles ? 1 : std::min<Index>(availableThreads(), kMostParts);
  const auto forSides = [&](const auto& visit) {
    parallelFor(parts, [&](Index part) {
      const auto first = static_cast<Index>(std::int64_t{vertices} * part / parts);
      const auto last = static_cast<Index>(std::int64_t{vertices} * (part + 1) / parts);
      for (Index t = 0; t < count; ++t) {
        if (t % kPolledTriangles == 0) poll();
        if (t % kTrianglesPerBlock == 0 && parts > 1) {
          const VertexRange& range = ranges[t / kTrianglesPerBlock];
          if (range.high < first || range.low >= last) {
            t += kTrianglesPerBlock - 1;
            continue;
          }
        }
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
  UnfilledArray<Entry> entries(static_cast<std::size_t>(count) * 3);
  forSides([&](Index smaller, Index larger, Index side) {
    entries.fill(bucket[smaller]++, static_cast<Entry>(larger) << 32 | static_cast<Entry>(side));
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
      if (begin == bucket[v]) continue;
      sortEntries(&entries[begin], &entries[begin] + (bucket[v] - begin));
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
  constexpr Index kEdgesPerBlock = 2048;
  const Index edgeCount = all.edgeCount();
  const auto blocks = static_cast<std::size_t>((edgeCount + kEdgesPerBlock - 1) / kEdgesPerBlock);
  std::vector<Index> edgesBefore(blocks + 1, 0), sidesBefore(blocks + 1, 0);
  const auto forBlocks = [&](const auto& work) {
    parallelFor(blocks, [&](std::size_t block) {
      poll();
      const Index first = static_cast<Index>(block) * kEdgesPerBlock;
      work(block, first, std::min(first + kEdgesPerBlock, edgeCount));
    });
  };
  forBlocks([&](std::size_t block, Index first, Index last) {
    Index edges = 0, sides = 0;
    for (Index e = first; e < last; ++e) {
      Index own = 0;
      for (const Index side : all.sidesOf(e)) own += static_cast<Index>(renumbered[side / 3] >= 0);
      sides += own;
      edges += static_cast<Index>(own > 0);
    }
    edgesBefore[block + 1] = edges;
    sidesBefore[block + 1] = sides;
  });
  std::partial_sum(edgesBefore.begin(), edgesBefore.end(), edgesBefore.begin());
  std::partial_sum(sidesBefore.begin(), sidesBefore.end(), sidesBefore.begin());
  Adjacency some;
  some.sides.resize(static_cast<std::size_t>(sidesBefore.back()));
  some.first.resize(static_cast<std::size_t>(edgesBefore.back()) + 1);
  some.first.back() = sidesBefore.back();
  forBlocks([&](std::size_t block, Index first, Index last) {
    Index edge = edgesBefore[block], next = sidesBefore[block];
    for (Index e = first; e < last; ++e) {
      const Index begin = next;
      for (const Index side : all.sidesOf(e))
        if (const Index t = renumbered[side / 3]; t >= 0) some.sides[next++] = 3 * t + side % 3;
      if (next > begin) some.first[edge++] = begin;
    }
  });
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
