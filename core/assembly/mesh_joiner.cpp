// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/mesh_joiner.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/disjoint_sets.hpp"
#include "core/base/geometry.hpp"
#include "core/mesh/triangle_split.hpp"

namespace footfall::detail {
namespace {

// Rounding of a scaled sum or product of coordinates, generously.
constexpr double kRounding = 8 * 0x1p-53;

constexpr std::size_t kPolled = 1 << 16;
constexpr std::size_t kVerticesPerTask = 4096;

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
  const auto low = [&](double c) { return c - v.error - std::fabs(c) * kRounding; };
  const auto high = [&](double c) { return c + v.error + std::fabs(c) * kRounding; };
  return {{low(v.x), low(v.y), low(v.z)}, {high(v.x), high(v.y), high(v.z)}};
}

}  // namespace

bool MeshJoiner::liesOnSourceEdge(const MeshVertex& vertex, const std::pair<Index, Index>& edge) const {
  if (vertex.source >= 0) return vertex.source == edge.first || vertex.source == edge.second;
  const PlanPoint& p = vertex.point;
  if (p.kind() != PlanPoint::EdgePlane || p.edgeBegin() != edge.first || p.edgeEnd() != edge.second) return false;
  const auto& f = mesh_.triangles[vertex.face];
  const auto isCorner = [&](Index v) { return f[0] == v || f[1] == v || f[2] == v; };
  return (isCorner(p.edgeBegin()) && isCorner(p.edgeEnd())) || (p.triangle() == vertex.face && p.level() == 0);
}

int MeshJoiner::compareCoordinate(Index a, Index b, int axis, bool exactly, ExactFallbacks& count) const {
  const MeshVertex &p = vertices_[a], &q = vertices_[b];
  const double u = axis == 0 ? p.x : p.y, v = axis == 0 ? q.x : q.y;
  const double bound = (p.error + q.error + (std::fabs(u) + std::fabs(v)) * kRounding) * kInflate;
  if (u - v > bound) return 1;
  if (u - v < -bound) return -1;
  return exactly ? kernel_.compare(p.point, q.point, axis, mesh_.triangles[p.face][0], count) : 0;
}

int MeshJoiner::compareAlong(const Outline& outline, Index a, Index b, ExactFallbacks& count) const {
  // An axis along which the ends differ for certain, the longer one if doubles can tell.
  const MeshVertex &from = vertices_[outline.from], &to = vertices_[outline.to];
  const int longer = std::fabs(to.x - from.x) > std::fabs(to.y - from.y) ? 0 : 1;
  int axis = longer;
  int forward = compareCoordinate(outline.to, outline.from, axis, false, count);
  for (int k = 0; k < 2 && forward == 0; ++k) {
    axis = k;
    forward = compareCoordinate(outline.to, outline.from, axis, true, count);
  }
  return forward * compareCoordinate(a, b, axis, true, count);
}

MeshJoiner::Relation MeshJoiner::relate(Index vertex, const Outline& outline, ExactFallbacks& count) const {
  const MeshVertex &p = vertices_[vertex], &a = vertices_[outline.from], &b = vertices_[outline.to];
  if (outline.sourceEdge.first < 0 || !liesOnSourceEdge(p, outline.sourceEdge)) {
    // Far from the line by the rounded coordinates?
    const double error = (p.error + a.error + b.error) * 2;
    const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z}, w{p.x - a.x, p.y - a.y, p.z - a.z};
    const std::array<double, 3> size{std::fabs(a.x) + std::fabs(b.x) + std::fabs(p.x),
                                     std::fabs(a.y) + std::fabs(b.y) + std::fabs(p.y),
                                     std::fabs(a.z) + std::fabs(b.z) + std::fabs(p.z)};
    for (int i = 0; i < 3; ++i) {
      const int j = next(i);
      const double left = u[i] * w[j], right = u[j] * w[i];
      const double di = error + size[i] * kRounding, dj = error + size[j] * kRounding;
      const double bound = ((std::fabs(u[i]) + std::fabs(w[i])) * dj + (std::fabs(u[j]) + std::fabs(w[j])) * di +
                            2 * di * dj + (std::fabs(left) + std::fabs(right)) * kRounding) *
                               kInflate +
                           kernel_.sign().slack;
      if (std::fabs(left - right) > bound) return Relation::Apart;
    }
    const Index origin = mesh_.triangles[outline.face][0];
    if (kernel_.side(outline.line, outline.face, p.point, origin, count) != 0) return Relation::Apart;
    const int height = p.source >= 0 ? kernel_.heightSign(outline.face, p.source, 0, count)
                                     : kernel_.compareHeight(p.point, p.face, outline.face, count);
    if (height != 0) return Relation::Apart;
  }
  const int start = compareAlong(outline, vertex, outline.from, count);
  if (start < 0) return Relation::Apart;
  if (start == 0) return Relation::AtStart;
  const int end = compareAlong(outline, vertex, outline.to, count);
  if (end > 0) return Relation::Apart;
  return end == 0 ? Relation::AtEnd : Relation::Between;
}

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
  std::vector<Index> vertexNow(before.vertexCount, -1);
  std::vector<Index> outlineNow(before.entries.back().firstOutline, -1);
  knownVertices_.assign(vertices_.size(), 0);
  knownOutlines_.assign(outlines_.size(), 0);
  for (std::size_t i = 0; i + 1 < memory_.entries.size(); ++i) {
    const JoinMemory::Entry &now = memory_.entries[i], &end = memory_.entries[i + 1];
    if (isChanged[now.face] != 0) continue;
    const JoinMemory::Entry& then = before.entries[entryBefore[earlier_->faceBefore(now.face)]];
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
  }
  // A vertex that was on the outline of a face that is still there was compared with all outlines. One that was only
  // inside such a face was not, and is searched for if it is on another outline now.
  const auto known = [&](Index vertex) { return vertexNow[vertex] >= 0 && knownVertices_[vertexNow[vertex]] != 0; };
  for (const Incidence& i : before.between)
    if (outlineNow[i.outline] >= 0 && known(i.vertex))
      memory_.between.push_back({outlineNow[i.outline], vertexNow[i.vertex]});
  for (const auto& [a, b] : before.equal)
    if (known(a) && known(b)) memory_.equal.emplace_back(vertexNow[a], vertexNow[b]);
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

void MeshJoiner::findIncidences(RunContext& context) {
  if (earlier_ != nullptr) copyEarlier();
  const auto boxOf = [&](Index v) { return boxAround(vertices_[v]); };
  const std::vector<Index> entries = entriesToSearch();
  Twins twins;
  std::vector<char> isSearched(vertices_.size(), 0);  // vertices on outlines
  Box bounds = emptyBox();
  const auto findSearched = [&] {
    forOutlines(entries, context, [&](Index i) {
      for (const Index v : {outlines_[i].from, outlines_[i].to})
        if (std::exchange(isSearched[v], 1) == 0) bounds = whole(bounds, boxOf(v));
    });
  };
  tbb::parallel_invoke([&] { twins = findTwins(entries, context); }, findSearched);
  TriangleTree tree;
  tree.build(
      bounds, twins.first,
      [&](std::size_t n) {
        const Outline& o = outlines_[twins.first[n]];
        return whole(boxOf(o.from), boxOf(o.to));
      },
      context);

  struct Local {
    std::vector<Incidence> between;
    std::vector<std::pair<Index, Index>> equal;
    std::vector<std::int32_t> stack;
    ExactFallbacks fallbacks;
  };
  tbb::enumerable_thread_specific<Local> locals;
  tbb::parallel_for(tbb::blocked_range<Index>(0, static_cast<Index>(isSearched.size()), 512), [&](const auto& range) {
    context.checkCancelled();
    Local& local = locals.local();
    for (Index v = range.begin(); v != range.end(); ++v) {
      if (isSearched[v] == 0) continue;
      const bool known = !knownVertices_.empty() && knownVertices_[v] != 0;
      tree.visitOverlapping(boxOf(v), local.stack, [&](std::int32_t first) {
        const Outline& o = outlines_[first];
        if (o.from == v || o.to == v) return true;
        context.checkCancelled();  // on a wide grid one comparison can take a tenth of a millisecond
        const auto isToDo = [&](Index i) { return !known || knownOutlines_[i] == 0; };
        bool any = false;
        for (Index i = first; i >= 0 && !any; i = twins.next[i]) any = isToDo(i);
        if (!any) return true;
        const Relation relation = relate(v, o, local.fallbacks);
        for (Index i = first; i >= 0 && relation == Relation::Between; i = twins.next[i])
          if (isToDo(i)) local.between.push_back({i, v});
        if (relation == Relation::AtStart) local.equal.emplace_back(v, o.from);
        if (relation == Relation::AtEnd) local.equal.emplace_back(v, o.to);
        return true;
      });
    }
  });
  for (Local& local : locals) {
    memory_.between.insert(memory_.between.end(), local.between.begin(), local.between.end());
    memory_.equal.insert(memory_.equal.end(), local.equal.begin(), local.equal.end());
    fallbacks_ += local.fallbacks;
  }
}

WalkableMesh MeshJoiner::join(RunContext& context) {
  memory_.vertexCount = static_cast<Index>(vertices_.size());
  findIncidences(context);
  context.checkCancelled();

  DisjointSets sets(vertices_.size());
  for (const auto& [a, b] : memory_.equal) sets.unite(a, b);
  std::vector<Incidence> between = memory_.between;
  for (Incidence& i : between) i.vertex = sets.find(i.vertex);
  std::sort(between.begin(), between.end(), [](const Incidence& a, const Incidence& b) {
    return a.outline != b.outline ? a.outline < b.outline : a.vertex < b.vertex;
  });
  between.erase(std::unique(between.begin(), between.end(),
                            [](const Incidence& a, const Incidence& b) {
                              return a.outline == b.outline && a.vertex == b.vertex;
                            }),
                between.end());

  std::vector<std::vector<Index>> splits;
  std::vector<std::array<Index, 3>> splitsOf;  // for each triangle and edge, or empty
  if (!between.empty()) splitsOf.assign(triangles_.size(), {-1, -1, -1});
  for (std::size_t i = 0; i < between.size();) {
    const Outline& o = outlines_[between[i].outline];
    std::vector<Index> on;
    std::size_t j = i;
    for (; j < between.size() && between[j].outline == between[i].outline; ++j) on.push_back(between[j].vertex);
    std::sort(on.begin(), on.end(), [&](Index a, Index b) { return compareAlong(o, a, b, fallbacks_) < 0; });
    splitsOf[o.triangle][o.k] = static_cast<Index>(splits.size());
    splits.push_back(std::move(on));
    i = j;
  }
  context.checkCancelled();

  WalkableMesh mesh;
  mesh.triangles.reserve(triangles_.size() + 2 * between.size());
  mesh.vertices.reserve(vertices_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (Index& v : triangles_[t].corners) v = sets.find(v);
    EdgeVertices on{};
    for (int k = 0; k < 3 && !splitsOf.empty(); ++k)
      if (splitsOf[t][k] >= 0) on[k] = &splits[splitsOf[t][k]];
    splitTriangle(triangles_[t], on, mesh.triangles);
  }
  context.checkCancelled();
  std::vector<Index> renumbered(vertices_.size(), -1);
  for (MeshTriangle& t : mesh.triangles) {
    for (Index& v : t.corners) {
      if (renumbered[v] < 0) {
        renumbered[v] = static_cast<Index>(mesh.vertices.size());
        mesh.vertices.push_back(vertices_[v]);
      }
      v = renumbered[v];
    }
  }
  return mesh;
}

JoinMemory MeshJoiner::takeMemory() { return std::move(memory_); }

}  // namespace footfall::detail
