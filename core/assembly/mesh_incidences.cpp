// The part of MeshJoiner that finds which vertices lie on which outlines.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The source geometry's own tree finds the faces near a vertex, which is compared with their edges, or with the
// outlines of those that something cuts. Only outlines of faces that have very many are in a tree of their own. Four
// neighbours along a curve share one search, unless too much is around them. All of this only chooses what is compared:
// boxes hold what they stand for, whatever is rounded.

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "core/assembly/mesh_joiner.hpp"
#include "core/base/float4.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"

namespace footfall::detail {

/// A box in floats relative to some centre, all rounded monotonically: boxes that overlap still do. Lane 3 is 0.
struct FloatBox {
  Float4 lower, upper;
};

namespace {

constexpr std::size_t kPolled = 1 << 16;
constexpr std::size_t kFacesPolled = 256;
constexpr std::size_t kVerticesPerTask = 1024;
constexpr std::size_t kEntriesPerTask = 2048;
constexpr std::size_t kSearchedPerTask = 1024;
constexpr std::size_t kGroup = 4;        // vertices that are looked for together, as many as lanes
constexpr std::size_t kMostAround = 64;  // faces, or outlines, around a group of more than one
constexpr Index kManyOutlines = 64;      // a face with more has them in a tree

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

FloatBox inFloats(const Box& box, const std::array<double, 3>& centre) {
  constexpr double kLargest = std::numeric_limits<float>::max() / 4;  // so that differences are finite
  FloatBox result{};
  for (int k = 0; k < 3; ++k) {
    result.lower[k] = static_cast<float>(std::clamp(box.lower[k] - centre[k], -kLargest, kLargest));
    result.upper[k] = static_cast<float>(std::clamp(box.upper[k] - centre[k], -kLargest, kLargest));
  }
  return result;
}

bool overlap(const FloatBox& a, const FloatBox& b) { return maskOf((a.lower <= b.upper) & (a.upper >= b.lower)) == 15; }

FloatBox whole(const FloatBox& a, const FloatBox& b) {
  return {a.lower < b.lower ? a.lower : b.lower, a.upper > b.upper ? a.upper : b.upper};
}

/// Puts two zeros between the lower ten bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000FFU;
  x = (x | x << 8) & 0x0300F00FU;
  x = (x | x << 4) & 0x030C30C3U;
  return (x | x << 2) & 0x09249249U;
}

/// Sorts vertices along Morton's curve through the box around all of them. `keys` is working memory.
void sortByMortonKey(std::vector<Index>& vertices, const UnfilledArray<FloatBox>& boxes,
                     std::vector<std::uint64_t>& keys) {
  if (vertices.size() <= kGroup) return;
  Float4 least = boxes[vertices[0]].lower, most = least;
  for (const Index v : vertices) {
    const Float4 place = boxes[v].lower;
    least = place < least ? place : least;
    most = place > most ? place : most;
  }
  const Float4 size = most - least;
  const float extent = std::max({size[0], size[1], size[2]});
  const float scale = std::isfinite(1023 / extent) ? 1023 / extent : 0;
  keys.clear();
  for (const Index v : vertices) {
    const Float4 place = (boxes[v].lower - least) * scale;
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) key |= spread(static_cast<std::uint32_t>(place[k])) << k;
    keys.push_back(key << 32 | static_cast<std::uint32_t>(v));
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = static_cast<Index>(keys[i]);
}

/// The largest number of faces around some vertices for which one search serves them together.
std::size_t mostAround(std::span<const Index> vertices) {
  return vertices.size() == 1 ? std::numeric_limits<std::size_t>::max() : kMostAround;
}

/// Lists what may overlap a box. Returns false, and lists not all, where that is more than `most`.
template <class Tree>
bool listOverlapping(const Tree& tree, const Box& box, std::size_t most, std::vector<std::int32_t>& stack,
                     std::vector<Index>& list) {
  list.clear();
  tree.visitOverlapping(box, stack, [&](Index id) {
    list.push_back(id);
    return list.size() <= most;
  });
  return list.size() <= most;
}

}  // namespace

struct MeshJoiner::Search {
  std::vector<Index> entryOf;     ///< entry of each face to be searched, or -1
  UnfilledArray<FloatBox> boxes;  ///< boxes of the vertices to be searched for
  TriangleTree crowded;           ///< tree over outlines of faces that have many
  PowerOfTwo toUnits;

  [[nodiscard]] FloatBox boxOf(const Outline& outline) const { return whole(boxes[outline.from], boxes[outline.to]); }
};

struct MeshJoiner::Group {
  Group(std::span<const Index> some, const Search& search) : vertices(some), around(search.boxes[some[0]]) {
    for (int k = 0; k < 3; ++k) {
      lower[k] = Float4{} + std::numeric_limits<float>::max();  // nothing overlaps what is not used
      upper[k] = -lower[k];
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const FloatBox& box = search.boxes[vertices[i]];
      around = whole(around, box);
      for (int k = 0; k < 3; ++k) {
        lower[k][i] = box.lower[k];
        upper[k][i] = box.upper[k];
      }
    }
  }

  /// Bit i: the box of vertex i overlaps this one.
  [[nodiscard]] unsigned overlapping(const FloatBox& box) const {
    Int4 hits = ~Int4{};
    for (int k = 0; k < 3; ++k) hits &= (lower[k] <= box.upper[k]) & (upper[k] >= box.lower[k]);
    return maskOf(hits);
  }

  std::span<const Index> vertices;
  FloatBox around;                     ///< around all
  std::array<Float4, 3> lower, upper;  ///< bounds of each box, by axis
};

struct MeshJoiner::Found {
  std::vector<Incidence> between;
  std::vector<std::pair<Index, Index>> equal;
  ExactFallbacks fallbacks;
  // Working memory:
  std::vector<std::int32_t> stack;
  std::vector<Index> vertices, faces, outlines;
  std::vector<std::uint64_t> keys;
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

bool MeshJoiner::isKnown(Index vertex) const { return !knownVertices_.empty() && knownVertices_[vertex] != 0; }

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

void MeshJoiner::fillBoxes(const std::vector<char>& isSearched, Search& search, RunContext& context) const {
  const MeshVertex& middle = vertices_[vertices_.size() / 2];
  const std::array<double, 3> centre{middle.x, middle.y, middle.z};
  search.boxes = UnfilledArray<FloatBox>(vertices_.size());
  forRanges(vertices_.size(), kVerticesPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    for (std::size_t v = first; v < last; ++v)
      if (isSearched[v] != 0) search.boxes.fill(v, inFloats(boxAround(vertices_[v]), centre));
  });
}

void MeshJoiner::buildTree(const std::vector<Index>& entries, Search& search, RunContext& context) const {
  std::vector<Index> outlines;
  for (std::size_t n = 0; n < entries.size(); ++n) {
    if (n % kPolled == 0) context.checkCancelled();
    const Index first = memory_.entries[entries[n]].firstOutline, end = memory_.entries[entries[n] + 1].firstOutline;
    if (end - first <= kManyOutlines) continue;
    for (Index i = first; i < end; ++i) outlines.push_back(i);
  }
  if (outlines.empty()) return;
  const auto boxOf = [&](std::size_t n) {
    const Outline& o = outlines_[outlines[n]];
    return whole(boxAround(vertices_[o.from]), boxAround(vertices_[o.to]));
  };
  Box bounds = boxOf(0);
  for (std::size_t n = 1; n < outlines.size(); ++n) {
    if (n % kPolled == 0) context.checkCancelled();
    bounds = whole(bounds, boxOf(n));
  }
  search.crowded.build(bounds, outlines, boxOf, context);
}

void MeshJoiner::compare(Index vertex, Index number, const Outline& outline, Found& found, RunContext& context) const {
  context.checkCancelled();  // One comparison on a wide grid can take a tenth of a millisecond.
  // Floats have little precision far from the middle of all vertices.
  if (!overlap(boxAround(vertices_[vertex]),
               whole(boxAround(vertices_[outline.from]), boxAround(vertices_[outline.to]))))
    return;
  const Relation relation = relate(vertex, outline, found.fallbacks);
  if (relation == Relation::Between) found.between.push_back({number, vertex});
  if (relation == Relation::AtStart) found.equal.emplace_back(vertex, outline.from);
  if (relation == Relation::AtEnd) found.equal.emplace_back(vertex, outline.to);
}

// A corner of a face is on none of its other edges.
void MeshJoiner::findOnWholeFace(Index entry, const Group& group, const Search& search, Found& found,
                                 RunContext& context) const {
  const auto& corners = triangles_[firstTriangle_[entry]].corners;
  const FloatBox &a = search.boxes[corners[0]], &b = search.boxes[corners[1]], &c = search.boxes[corners[2]];
  for (unsigned hits = group.overlapping(whole(whole(a, b), c)); hits != 0; hits &= hits - 1) {
    const Index vertex = group.vertices[std::countr_zero(hits)];
    if (corners[0] == vertex || corners[1] == vertex || corners[2] == vertex) continue;
    if (isKnown(vertex) && knownEntries_[entry] != 0) continue;
    const std::array<FloatBox, 3> edges{whole(a, b), whole(b, c), whole(c, a)};
    for (int k = 0; k < 3; ++k) {
      if (!overlap(search.boxes[vertex], edges[k]) || isFar(vertex, corners[k], corners[next(k)])) continue;
      const Index number = JoinMemory::edgeOfWhole(entry, k);
      compare(vertex, number, outlineOf(number), found, context);
    }
  }
}

void MeshJoiner::findOnOutline(Index number, const FloatBox& box, const Group& group, Found& found,
                               RunContext& context) const {
  const Outline& o = outlines_[number];
  for (unsigned hits = group.overlapping(box); hits != 0; hits &= hits - 1) {
    const Index vertex = group.vertices[std::countr_zero(hits)];
    if (o.from == vertex || o.to == vertex || (isKnown(vertex) && knownOutlines_[number] != 0)) continue;
    if (!isFar(vertex, o.from, o.to)) compare(vertex, number, o, found, context);
  }
}

Box MeshJoiner::boxAroundAll(std::span<const Index> vertices) const {
  Box box = boxAround(vertices_[vertices[0]]);
  for (const Index vertex : vertices.subspan(1)) box = whole(box, boxAround(vertices_[vertex]));
  return box;
}

bool MeshJoiner::findTogether(std::span<const Index> vertices, const Search& search, Found& found,
                              RunContext& context) const {
  const Box box = inUnits(boxAroundAll(vertices), search.toUnits);
  if (!listOverlapping(mesh_.tree, box, mostAround(vertices), found.stack, found.faces)) return false;
  const Group group(vertices, search);
  bool anyCrowded = false;
  for (std::size_t n = 0; n < found.faces.size(); ++n) {
    if (n % kFacesPolled == 0) context.checkCancelled();
    const Index face = found.faces[n];
    const Index entry = search.entryOf[face];
    if (entry < 0) continue;
    const Index first = memory_.entries[entry].firstOutline, end = memory_.entries[entry + 1].firstOutline;
    if (isWhole(entry)) findOnWholeFace(entry, group, search, found, context);
    if (end - first > kManyOutlines)
      anyCrowded = true;
    else
      for (Index i = first; i < end; ++i)
        if (const FloatBox outline = search.boxOf(outlines_[i]); overlap(outline, group.around))
          findOnOutline(i, outline, group, found, context);
  }
  if (anyCrowded) findOnCrowded(vertices, search, found, context);
  return true;
}

void MeshJoiner::findOnCrowded(std::span<const Index> vertices, const Search& search, Found& found,
                               RunContext& context) const {
  if (listOverlapping(search.crowded, boxAroundAll(vertices), mostAround(vertices), found.stack, found.outlines)) {
    const Group group(vertices, search);
    for (const Index i : found.outlines) findOnOutline(i, search.boxOf(outlines_[i]), group, found, context);
    return;
  }
  const std::size_t half = vertices.size() / 2;
  findOnCrowded(vertices.first(half), search, found, context);
  findOnCrowded(vertices.subspan(half), search, found, context);
}

void MeshJoiner::findIncidences(RunContext& context) {
  if (earlier_ != nullptr) copyEarlier();
  if (vertices_.size() == 0) return;
  const std::vector<Index> entries = entriesToSearch();
  Search search{{}, {}, {}, PowerOfTwo(-mesh_.grid.scaleExponent())};
  std::vector<char> isSearched;
  const auto findSearched = [&] {
    isSearched = verticesOn(entries, context);
    fillBoxes(isSearched, search, context);
    search.entryOf.assign(mesh_.triangles.size(), -1);
    for (const Index entry : entries) search.entryOf[memory_.entries[entry].face] = entry;
  };
  parallelInvoke([&] { buildTree(entries, search, context); }, findSearched);

  PerThread<Found> locals;
  forRanges(isSearched.size(), kSearchedPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    Found& found = locals.local();
    found.vertices.clear();
    for (std::size_t v = first; v < last; ++v)
      if (isSearched[v] != 0) found.vertices.push_back(static_cast<Index>(v));
    sortByMortonKey(found.vertices, search.boxes, found.keys);
    // A group with too many faces around it is made smaller; then groups grow again.
    const std::span<const Index> vertices = found.vertices;
    std::size_t size = kGroup;
    for (std::size_t done = 0; done < vertices.size();) {
      const std::size_t count = std::min(size, vertices.size() - done);
      if (findTogether(vertices.subspan(done, count), search, found, context)) {
        done += count;
        size = std::min(2 * size, kGroup);
      } else {
        size = count / 2;
      }
    }
  });
  for (Found& found : locals) {
    memory_.between.insert(memory_.between.end(), found.between.begin(), found.between.end());
    memory_.equal.insert(memory_.equal.end(), found.equal.begin(), found.equal.end());
    fallbacks_ += found.fallbacks;
  }
}

}  // namespace footfall::detail
