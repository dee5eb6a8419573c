// How a MeshJoiner finds which vertices lie on which outlines.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Most floors are whole: their edges are found by the source geometry's own tree, and nothing is stored of them.
// Outlines of faces that something cuts are in a tree of their own, one of each set between the same two vertices.
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>

#include "core/assembly/mesh_joiner.hpp"
#include "core/base/geometry.hpp"
#include "core/base/parallel_ranges.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 1 << 16;
constexpr std::size_t kVerticesPerTask = 4096;
constexpr std::size_t kEntriesPerTask = 8192;
constexpr std::size_t kSearchedPerTask = 512;

Box emptyBox() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

Box whole(const Box& a, const Box& b) {
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = std::min(a.lower[k], b.lower[k]);
    box.upper[k] = std::max(a.upper[k], b.upper[k]);
  }
  return box;
}

/// Holds the exact place of the vertex.
Box boxAround(const MeshVertex& v) {
  const auto low = [&](double c) { return c - v.error - std::fabs(c) * kCoordinateRounding; };
  const auto high = [&](double c) { return c + v.error + std::fabs(c) * kCoordinateRounding; };
  return {{low(v.x), low(v.y), low(v.z)}, {high(v.x), high(v.y), high(v.z)}};
}

/// A box in scaled coordinates in those of the environment; what underflows gets as much room.
Box inUnits(const Box& scaled, const PowerOfTwo& toUnits) {
  constexpr double kSmallest = std::numeric_limits<double>::min();
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = toUnits(scaled.lower[k]) - kSmallest;
    box.upper[k] = toUnits(scaled.upper[k]) + kSmallest;
  }
  return box;
}

}  // namespace

struct MeshJoiner::Search {
  std::vector<Index> entryOf;  ///< for each face that is whole and to be looked at its entry, or -1
  Twins twins;
  TriangleTree tree;  ///< over the first of the twins
  PowerOfTwo toUnits;
};

struct MeshJoiner::Found {
  std::vector<Incidence> between;
  std::vector<std::pair<Index, Index>> equal;
  std::vector<std::int32_t> stack;
  ExactFallbacks fallbacks;
};

void MeshJoiner::reuse(const EarlierResult& earlier, std::vector<Index> changed) {
  earlier_ = &earlier;
  changed_ = std::move(changed);
}

// Points and outlines of a face that did not change have the same places among the face's own as before.
void MeshJoiner::copyEarlier() {
  const JoinMemory& before = earlier_->state().memory->join;
  std::vector<Index> entryBefore(earlier_->state().walkable.size(), -1);
  for (std::size_t i = 0; i + 1 < before.entries.size(); ++i)
    entryBefore[before.entries[i].face] = static_cast<Index>(i);
  std::vector<char> isChanged(mesh_.triangles.size(), 0);
  for (const Index face : changed_) isChanged[face] = 1;
  std::vector<Index> vertexNow(before.vertexCount, -1), entryNow(before.entries.size(), -1);
  std::vector<Index> outlineNow(before.entries.back().firstOutline, -1);
  knownVertices_.assign(vertices_.size(), 0);
  knownOutlines_.assign(outlines_.size(), 0);
  knownEntries_.assign(memory_.entries.size(), 0);
  for (std::size_t i = 0; i + 1 < memory_.entries.size(); ++i) {
    const JoinMemory::Entry &now = memory_.entries[i], &end = memory_.entries[i + 1];
    if (isChanged[now.face] != 0) continue;
    const Index entry = entryBefore[earlier_->faceBefore(now.face)];
    const JoinMemory::Entry& then = before.entries[entry];
    entryNow[entry] = static_cast<Index>(i);
    for (Index p = now.firstPoint; p < end.firstPoint; ++p) {
      const Index vertex = memory_.vertexOf[p];
      if (vertex < 0) continue;
      vertexNow[before.vertexOf[then.firstPoint + p - now.firstPoint]] = vertex;
    }
    for (Index o = now.firstOutline; o < end.firstOutline; ++o) {
      outlineNow[then.firstOutline + o - now.firstOutline] = o;
      knownOutlines_[o] = 1;
      knownVertices_[outlines_[o].from] = knownVertices_[outlines_[o].to] = 1;
    }
    if (!isWhole(static_cast<Index>(i))) continue;
    knownEntries_[i] = 1;
    for (const Index v : triangles_[firstTriangle_[i]].corners) knownVertices_[v] = 1;
  }
  const auto numberNow = [&](Index outline) {
    if (outline >= 0) return outlineNow[outline];
    const auto [entry, k] = JoinMemory::wholeOf(outline);
    return entryNow[entry] < 0 ? -1 : JoinMemory::edgeOfWhole(entryNow[entry], k);
  };
  // A vertex that was on the outline of a face that is still there was compared with all outlines. One that was only
  // inside such a face was not, and is searched for if it is on another outline now.
  const auto known = [&](Index vertex) { return vertexNow[vertex] >= 0 && knownVertices_[vertexNow[vertex]] != 0; };
  for (const Incidence& i : before.between)
    if (const Index outline = numberNow(i.outline); outline != -1 && known(i.vertex))
      memory_.between.push_back({outline, vertexNow[i.vertex]});
  for (const auto& [a, b] : before.equal)
    if (known(a) && known(b)) memory_.equal.emplace_back(vertexNow[a], vertexNow[b]);
}

bool MeshJoiner::isWhole(Index entry) const {
  const auto& entries = memory_.entries;
  return firstTriangle_[entry + 1] - firstTriangle_[entry] == 1 &&
         entries[entry + 1].firstOutline == entries[entry].firstOutline;
}

MeshJoiner::Outline MeshJoiner::outlineOf(Index number) const {
  if (number >= 0) return outlines_[number];
  const auto [entry, k] = JoinMemory::wholeOf(number);
  const Index t = firstTriangle_[entry];
  const MeshTriangle& triangle = triangles_[t];
  const auto& f = mesh_.triangles[triangle.face];
  const Index u = f[k], v = f[next(k)];
  const Index a = mesh_.planIds[u], b = mesh_.planIds[v];
  return {triangle.corners[k],
          triangle.corners[next(k)],
          t,
          static_cast<std::int8_t>(k),
          triangle.face,
          {PlanLine::Edge, std::min(a, b), std::max(a, b)},
          {std::min(u, v), std::max(u, v)}};
}

std::vector<Index> MeshJoiner::entriesToSearch() const {
  const std::size_t count = memory_.entries.size() - 1;
  std::vector<char> wanted(count, earlier_ == nullptr ? 1 : 0);
  if (earlier_ != nullptr) {
    std::vector<Index> entryOf(mesh_.triangles.size(), -1);
    for (std::size_t i = 0; i < count; ++i) entryOf[memory_.entries[i].face] = static_cast<Index>(i);
    std::vector<std::int32_t> stack;
    for (const Index face : changed_) {
      if (entryOf[face] < 0) continue;
      mesh_.tree.visitOverlapping(boxOf(mesh_, face), stack, [&](Index other) {
        if (entryOf[other] >= 0) wanted[entryOf[other]] = 1;
        return true;
      });
    }
  }
  std::vector<Index> entries;
  for (std::size_t i = 0; i < count; ++i)
    if (wanted[i] != 0) entries.push_back(static_cast<Index>(i));
  return entries;
}

template <class Visit>
void MeshJoiner::forOutlines(const std::vector<Index>& entries, RunContext& context, const Visit& visit) const {
  for (std::size_t n = 0; n < entries.size(); ++n) {
    if (n % kPolled == 0) context.checkCancelled();
    const Index end = memory_.entries[entries[n] + 1].firstOutline;
    for (Index i = memory_.entries[entries[n]].firstOutline; i < end; ++i) visit(i);
  }
}

// Parts that meet in a whole edge have an outline each there: what lies on one of them lies on the other. A counting
// sort by the smaller vertex, then each vertex's few outlines by the larger one.
MeshJoiner::Twins MeshJoiner::findTwins(const std::vector<Index>& entries, RunContext& context) const {
  const auto smaller = [&](Index i) { return std::min(outlines_[i].from, outlines_[i].to); };
  const auto larger = [&](Index i) { return std::max(outlines_[i].from, outlines_[i].to); };
  std::vector<Index> bucket(vertices_.size() + 1, 0);
  forOutlines(entries, context, [&](Index i) { ++bucket[smaller(i)]; });
  Index sum = 0;
  for (Index& size : bucket) sum += std::exchange(size, sum);
  Twins twins;
  twins.first.resize(sum);
  forOutlines(entries, context, [&](Index i) { twins.first[bucket[smaller(i)]++] = i; });
  // Now bucket[v] is where the outlines of v end. Those that are not the first of theirs become -1.
  twins.next.assign(outlines_.size(), -1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices_.size(), kVerticesPerTask), [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      const std::span<Index> here(twins.first.data() + (v == 0 ? 0 : bucket[v - 1]), twins.first.data() + bucket[v]);
      std::sort(here.begin(), here.end(), [&](Index a, Index b) {
        const Index p = larger(a), q = larger(b);
        return p != q ? p < q : a < b;
      });
      Index last = -1;
      for (Index& i : here) {
        const Index before = std::exchange(last, i);
        if (before < 0 || larger(before) != larger(i)) continue;
        twins.next[before] = i;
        i = -1;
      }
    }
  });
  std::erase(twins.first, -1);
  return twins;
}

std::vector<char> MeshJoiner::verticesOn(const std::vector<Index>& entries, RunContext& context) const {
  std::vector<char> marks(vertices_.size(), 0);
  const auto mark = [&](Index v) { std::atomic_ref<char>(marks[v]).store(1, std::memory_order_relaxed); };
  forRanges(entries.size(), kEntriesPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    for (std::size_t n = first; n < last; ++n) {
      const Index entry = entries[n];
      if (isWhole(entry))
        for (const Index v : triangles_[firstTriangle_[entry]].corners) mark(v);
      const Index end = memory_.entries[entry + 1].firstOutline;
      for (Index i = memory_.entries[entry].firstOutline; i < end; ++i) {
        mark(outlines_[i].from);
        mark(outlines_[i].to);
      }
    }
  });
  return marks;
}

void MeshJoiner::buildTree(Search& search, RunContext& context) const {
  const std::vector<Index>& first = search.twins.first;
  const auto boxOf = [&](std::size_t n) {
    const Outline& o = outlines_[first[n]];
    return whole(boxAround(vertices_[o.from]), boxAround(vertices_[o.to]));
  };
  Box bounds = emptyBox();
  for (std::size_t n = 0; n < first.size(); ++n) {
    if (n % kPolled == 0) context.checkCancelled();
    bounds = whole(bounds, boxOf(n));
  }
  if (!first.empty()) search.tree.build(bounds, first, boxOf, context);
}

void MeshJoiner::findOnOutlines(Index vertex, const Box& box, const Search& search, Found& found,
                                RunContext& context) const {
  const bool known = !knownVertices_.empty() && knownVertices_[vertex] != 0;
  search.tree.visitOverlapping(box, found.stack, [&](std::int32_t first) {
    const Outline& o = outlines_[first];
    if (o.from == vertex || o.to == vertex) return true;
    context.checkCancelled();  // on a wide grid one comparison can take a tenth of a millisecond
    const auto isToDo = [&](Index i) { return !known || knownOutlines_[i] == 0; };
    bool any = false;
    for (Index i = first; i >= 0 && !any; i = search.twins.next[i]) any = isToDo(i);
    if (!any) return true;
    const Relation relation = relate(vertex, o, found.fallbacks);
    for (Index i = first; i >= 0 && relation == Relation::Between; i = search.twins.next[i])
      if (isToDo(i)) found.between.push_back({i, vertex});
    if (relation == Relation::AtStart) found.equal.emplace_back(vertex, o.from);
    if (relation == Relation::AtEnd) found.equal.emplace_back(vertex, o.to);
    return true;
  });
}

// A corner of a face is on none of its other edges.
void MeshJoiner::findOnWholeFaces(Index vertex, const Box& box, const Search& search, Found& found,
                                  RunContext& context) const {
  const bool known = !knownVertices_.empty() && knownVertices_[vertex] != 0;
  mesh_.tree.visitOverlapping(inUnits(box, search.toUnits), found.stack, [&](Index face) {
    const Index entry = search.entryOf[face];
    if (entry < 0 || (known && knownEntries_[entry] != 0)) return true;
    const auto& corners = triangles_[firstTriangle_[entry]].corners;
    if (corners[0] == vertex || corners[1] == vertex || corners[2] == vertex) return true;
    context.checkCancelled();
    for (int k = 0; k < 3; ++k) {
      const Index from = corners[k], to = corners[next(k)];
      if (!overlap(box, whole(boxAround(vertices_[from]), boxAround(vertices_[to])))) continue;
      const Index number = JoinMemory::edgeOfWhole(entry, k);
      const Relation relation = relate(vertex, outlineOf(number), found.fallbacks);
      if (relation == Relation::Between) found.between.push_back({number, vertex});
      if (relation == Relation::AtStart) found.equal.emplace_back(vertex, from);
      if (relation == Relation::AtEnd) found.equal.emplace_back(vertex, to);
    }
    return true;
  });
}

void MeshJoiner::findIncidences(RunContext& context) {
  if (earlier_ != nullptr) copyEarlier();
  const std::vector<Index> entries = entriesToSearch();
  Search search{{}, {}, {}, PowerOfTwo(-mesh_.grid.scaleExponent())};
  std::vector<char> isSearched;
  const auto findSearched = [&] {
    isSearched = verticesOn(entries, context);
    search.entryOf.assign(mesh_.triangles.size(), -1);
    for (const Index entry : entries)
      if (isWhole(entry)) search.entryOf[memory_.entries[entry].face] = entry;
  };
  tbb::parallel_invoke(
      [&] {
        search.twins = findTwins(entries, context);
        buildTree(search, context);
      },
      findSearched);

  tbb::enumerable_thread_specific<Found> locals;
  forRanges(isSearched.size(), kSearchedPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    Found& found = locals.local();
    for (auto v = static_cast<Index>(first); v < static_cast<Index>(last); ++v) {
      if (isSearched[v] == 0) continue;
      const Box box = boxAround(vertices_[v]);
      findOnOutlines(v, box, search, found, context);
      findOnWholeFaces(v, box, search, found, context);
    }
  });
  for (Found& found : locals) {
    memory_.between.insert(memory_.between.end(), found.between.begin(), found.between.end());
    memory_.equal.insert(memory_.equal.end(), found.equal.begin(), found.equal.end());
    fallbacks_ += found.fallbacks;
  }
}

}  // namespace footfall::detail
