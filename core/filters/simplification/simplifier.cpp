// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/simplification/simplifier.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/mesh/first_uses.hpp"

namespace footfall::detail {
namespace {

constexpr Index kEdgesPerTask = 1024;
constexpr Index kVerticesPerTask = 1024;
constexpr std::size_t kTrianglesPerBlock = 2048;
constexpr Index kTrianglesPerTask = 1024;
constexpr Index kPolled = 1 << 16;

/// The other ends of the outline edges at a vertex, while there are at most two.
struct OutlineEnds {
  std::array<Index, 2> ends{-1, -1};
  int count = 0;  ///< 3 stands for more than two
  void add(Index end) {
    if (count > 2 || (count > 0 && ends[0] == end) || (count > 1 && ends[1] == end)) return;
    if (count < 2) ends[count] = end;
    ++count;
  }
};

}  // namespace

WalkableMesh Simplifier::run(SimplifierMemory* memory) {
  std::vector<char> candidates;
  Groups groups;
  const auto prepare = [&] {
    findInnerEdges();
    candidates = findCandidates();
    parallelInvoke([&] { mesh_.around.build(mesh_.triangles, candidates); }, [&] { groups = findGroups(candidates); });
    context_.checkCancelled();
  };
  if (before_ != nullptr)
    parallelInvoke(prepare, [&] { relation_ = relateMeshes(*earlier_, *before_->given, given_); });
  else
    prepare();
  mesh_.alive.assign(mesh_.triangles.size(), 1);
  if (approximate_.enabled) mesh_.standsFor.resize(mesh_.triangles.size());
  if (memory != nullptr) memory->neighbors = mesh_.neighbors;
  if (before_ != nullptr)
    for (const Index g : before_->groupOf) {
      if (g >= static_cast<Index>(sizeBefore_.size())) sizeBefore_.resize(g + 1, 0);
      if (g >= 0) ++sizeBefore_[g];
    }

  PerThread<RegionSimplifier> simplifiers([&] { return RegionSimplifier(kernel_, mesh_, approximate_, context_); });
  std::atomic<Index> done{0};
  const auto runTask = [&](std::size_t task) {
    RegionSimplifier& simplifier = simplifiers.local();
    const Index first = groups.firstOfTask[task], last = groups.firstOfTask[task + 1];
    for (Index g = first; g < last; ++g) {
      const auto triangles = groups.trianglesOf(g), vertices = groups.verticesOf(g);
      if (before_ != nullptr && isKnown(triangles, candidates))
        copyEarlier(triangles);
      else
        simplifier.simplify(vertices, triangles);
    }
    const Index size = groups.firstTriangle[last] - groups.firstTriangle[first];
    context_.progress(static_cast<double>(done.fetch_add(size, std::memory_order_relaxed) + size) /
                      static_cast<double>(groups.triangles.size()));
  };
  parallelFor(groups.firstOfTask.size() - 1, runTask);
  for (const RegionSimplifier& simplifier : simplifiers) fallbacks_ += simplifier.fallbacks();
  // Memory that is no longer needed makes room for the result.
  mesh_.neighbors = {};
  mesh_.around = {};
  groups.triangles = {};
  groups.vertices = {};
  WalkableMesh result = compact();
  if (memory != nullptr) {
    memory->candidates = std::move(candidates);
    memory->groupOf = std::move(groups.of);
    memory->triangles = std::move(mesh_.triangles);
    memory->alive = std::move(mesh_.alive);
  }
  return result;
}

// The same triangles, joined alike, with the same vertices that may go: all in the same order, by which every choice is
// made.
bool Simplifier::isKnown(std::span<const Index> triangles, const std::vector<char>& candidates) const {
  const std::vector<Index>& then = relation_.triangleBefore;
  const Index first = then[triangles[0]];
  const Index group = first < 0 ? -1 : before_->groupOf[first];
  if (group < 0 || sizeBefore_[group] != static_cast<Index>(triangles.size())) return false;
  Index last = -1;
  for (const Index t : triangles) {
    if (then[t] <= last || before_->groupOf[then[t]] != group) return false;
    last = then[t];
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh_.triangles[t].corners[k], side = mesh_.neighbors[3 * t + k];
      if (candidates[v] != before_->candidates[relation_.vertexBefore[v]]) return false;
      const Index sideThen = before_->neighbors[3 * then[t] + k];
      if (side < 0 ? sideThen >= 0 : sideThen != 3 * then[side / 3] + side % 3) return false;
    }
  }
  return true;
}

void Simplifier::copyEarlier(std::span<const Index> triangles) {
  for (const Index t : triangles) {
    const Index then = relation_.triangleBefore[t];
    mesh_.alive[t] = before_->alive[then];
    MeshTriangle triangle = before_->triangles[then];
    for (Index& v : triangle.corners) v = relation_.vertexNow[v];
    triangle.face = earlier_->faceNow(triangle.face);
    mesh_.triangles[t] = triangle;
  }
}

bool Simplifier::mayJoin(Index face, Index other) {
  const auto unit = [&](Index f) {
    const auto& n = kernel_.mesh().normals[f];
    const double length = std::sqrt(n[0].value * n[0].value + n[1].value * n[1].value + n[2].value * n[2].value);
    return std::array<double, 3>{n[0].value / length, n[1].value / length, n[2].value / length};
  };
  const auto u = unit(face), v = unit(other);
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2] > 1 - approximate_.tolerance;
}

// Returns whether no obstacle stands on the edge, both sides are in one layer, and neither is folded over the other.
bool Simplifier::isInner(std::span<const Index> sides) const {
  if (sides.size() != 2 || isObstacle(mesh_.triangles, sides)) return false;
  const auto& layers = given_.layers;
  if (!layers.empty() && layers[sides[0] / 3] != layers[sides[1] / 3]) return false;
  const TriangleCorners corners(mesh_.triangles);
  return corners.beginOf(sides[0]) != corners.beginOf(sides[1]);
}

// Both sides of an edge belong to one region when it is inner and their planes agree.
void Simplifier::findInnerEdges() {
  mesh_.neighbors.assign(mesh_.triangles.size() * 3, -1);
  const auto join = [&](std::span<const Index> sides) {
    mesh_.neighbors[sides[0]] = sides[1];
    mesh_.neighbors[sides[1]] = sides[0];
  };
  const auto faceOf = [&](Index side) { return mesh_.triangles[side / 3].face; };
  if (approximate_.enabled) {
    // The first face of a region speaks for it, so that a curved floor does not count as flat.
    DisjointSets planes(kernel_.mesh().triangles.size());
    for (Index e = 0; e < topology_.edgeCount(); ++e) {
      if (e % kPolled == 0) context_.checkCancelled();
      const auto sides = topology_.sidesOf(e);
      if (!isInner(sides)) continue;
      const Index f = planes.find(faceOf(sides[0])), g = planes.find(faceOf(sides[1]));
      if (f != g && !mayJoin(f, g)) continue;
      planes.unite(f, g);
      join(sides);
    }
    return;
  }
  PerThread<ExactFallbacks> fallbacks;
  const Index edgeCount = topology_.edgeCount(), blocks = (edgeCount + kEdgesPerTask - 1) / kEdgesPerTask;
  outlines_.resize(blocks);
  parallelFor(blocks, [&](Index block) {
    context_.checkCancelled();
    ExactFallbacks& count = fallbacks.local();
    std::vector<std::array<Index, 2>> outlines;
    for (Index e = block * kEdgesPerTask; e < std::min((block + 1) * kEdgesPerTask, edgeCount); ++e) {
      const auto sides = topology_.sidesOf(e);
      const auto isOneRegion = [&] {
        const Index f = faceOf(sides[0]), g = faceOf(sides[1]);
        return f == g || kernel_.coplanar(std::min(f, g), std::max(f, g), count);
      };
      if (isInner(sides) && isOneRegion()) {
        join(sides);
      } else {
        const auto& corners = mesh_.triangles[sides[0] / 3].corners;
        outlines.push_back({corners[sides[0] % 3], corners[(sides[0] % 3 + 1) % 3]});
      }
    }
    outlines_[block] = std::move(outlines);
  });
  for (const ExactFallbacks& count : fallbacks) fallbacks_ += count;
}

std::vector<char> Simplifier::findCandidates() {
  const auto count = static_cast<Index>(mesh_.vertices.size());
  std::vector<char> candidates = approximate_.enabled ? std::vector<char>(count, 1) : findStraight(count);
  for (const MeshLink& link : given_.links)
    for (const Index v : {link.from[0], link.from[1], link.to[0], link.to[1]}) candidates[v] = 0;
  return candidates;
}

std::vector<char> Simplifier::findStraight(Index count) {
  std::vector<OutlineEnds> outline(count);
  for (const auto& block : outlines_) {
    context_.checkCancelled();
    for (const auto& [a, b] : block) {
      outline[a].add(b);
      outline[b].add(a);
    }
  }
  outlines_.clear();
  std::vector<char> candidates(count);
  PerThread<MeshGeometry> geometries([&] { return MeshGeometry(kernel_, mesh_.vertices); });
  parallelRanges(count, kVerticesPerTask, [&](const auto& range) {
    context_.checkCancelled();
    MeshGeometry& geometry = geometries.local();
    for (Index v = range.begin(); v != range.end(); ++v) {
      const OutlineEnds& o = outline[v];
      candidates[v] = static_cast<char>(o.count == 0 || (o.count == 2 && geometry.isBetween(o.ends[0], v, o.ends[1])));
    }
  });
  for (const MeshGeometry& geometry : geometries) fallbacks_ += geometry.fallbacks;
  return candidates;
}

Simplifier::Groups Simplifier::findGroups(const std::vector<char>& candidates) const {
  const auto count = static_cast<Index>(mesh_.triangles.size());
  DisjointSets sets(mesh_.triangles.size());
  for (Index s = 0; s < 3 * count; ++s)
    if (mesh_.neighbors[s] > s) sets.unite(s / 3, mesh_.neighbors[s] / 3);
  context_.checkCancelled();
  std::vector<Index> triangleAt(candidates.size(), -1);  // one at each vertex that may go
  for (Index t = 0; t < count; ++t)
    for (const Index v : mesh_.triangles[t].corners) {
      if (candidates[v] == 0) continue;
      if (triangleAt[v] >= 0) sets.unite(triangleAt[v], t);
      triangleAt[v] = t;
    }
  context_.checkCancelled();
  // A triangle alone has nothing that could go or be flipped.
  std::vector<Index> size(count, 0);
  for (Index t = 0; t < count; ++t) ++size[sets.find(t)];
  std::vector<Index> roots;
  for (Index t = 0; t < count; ++t)
    if (size[t] > 1) roots.push_back(t);
  std::stable_sort(roots.begin(), roots.end(), [&](Index a, Index b) { return size[a] > size[b]; });

  context_.checkCancelled();

  Groups groups;
  std::vector<Index> groupOf(count, -1);
  for (std::size_t g = 0; g < roots.size(); ++g) {
    groupOf[roots[g]] = static_cast<Index>(g);
    groups.firstTriangle.push_back(groups.firstTriangle.back() + size[roots[g]]);
    const Index last = groups.firstTriangle.back();
    if (last - groups.firstTriangle[groups.firstOfTask.back()] >= kTrianglesPerTask || g + 1 == roots.size())
      groups.firstOfTask.push_back(static_cast<Index>(g) + 1);
  }
  groups.triangles.resize(groups.firstTriangle.back());
  groups.of.resize(count);
  std::vector<Index> next = groups.firstTriangle;
  for (Index t = 0; t < count; ++t) {
    const Index g = groups.of[t] = groupOf[sets.find(t)];
    if (g >= 0) groups.triangles[next[g]++] = t;
  }
  context_.checkCancelled();
  const auto groupAt = [&](std::size_t v) { return triangleAt[v] < 0 ? -1 : groups.of[triangleAt[v]]; };
  groups.firstVertex.assign(roots.size() + 1, 0);
  for (std::size_t v = 0; v < candidates.size(); ++v)
    if (const Index g = groupAt(v); g >= 0) ++groups.firstVertex[g + 1];
  for (std::size_t g = 0; g < roots.size(); ++g) groups.firstVertex[g + 1] += groups.firstVertex[g];
  groups.vertices.resize(groups.firstVertex.back());
  next = groups.firstVertex;
  for (Index t = 0; t < count; ++t)
    for (const Index v : mesh_.triangles[t].corners) {
      if (triangleAt[v] < 0) continue;
      const Index g = groups.of[t];
      if (g >= 0) groups.vertices[next[g]++] = v;
      triangleAt[v] = -1;
    }
  return groups;
}

void Simplifier::copyAlive(WalkableMesh& result) const {
  const std::size_t count = mesh_.triangles.size();
  std::vector<std::size_t> firstOfBlock((count + kTrianglesPerBlock - 1) / kTrianglesPerBlock + 1, 0);
  const auto forBlocks = [&](auto work) {
    parallelFor(firstOfBlock.size() - 1, [&](std::size_t block) {
      context_.checkCancelled();
      work(block, block * kTrianglesPerBlock, std::min((block + 1) * kTrianglesPerBlock, count));
    });
  };
  forBlocks([&](std::size_t block, std::size_t first, std::size_t last) {
    firstOfBlock[block + 1] = static_cast<std::size_t>(
        std::count_if(mesh_.alive.data() + first, mesh_.alive.data() + last, [](auto alive) { return alive != 0; }));
  });
  std::partial_sum(firstOfBlock.begin(), firstOfBlock.end(), firstOfBlock.begin());
  result.triangles.resize(firstOfBlock.back());
  if (!given_.layers.empty()) result.layers.resize(firstOfBlock.back());
  forBlocks([&](std::size_t block, std::size_t first, std::size_t last) {
    std::size_t place = firstOfBlock[block];
    for (std::size_t t = first; t < last; ++t) {
      if (mesh_.alive[t] == 0) continue;
      if (!given_.layers.empty()) result.layers[place] = given_.layers[t];
      result.triangles[place++] = mesh_.triangles[t];
    }
  });
}

WalkableMesh Simplifier::compact() const {
  WalkableMesh result;
  FirstUses uses;
  parallelInvoke([&] { copyAlive(result); },
                 [&] {
                   const auto cornersOf = [&](std::size_t t) {
                     const auto& corners = mesh_.triangles[t].corners;
                     return mesh_.alive[t] != 0 ? std::span(corners) : std::span(corners).first(0);
                   };
                   uses = findFirstUses(mesh_.triangles.size(), mesh_.vertices.size(), cornersOf, context_);
                 });
  parallelInvoke([&] { renumber(result.triangles, uses, context_); },
                 [&] { result.vertices.resize(uses.order.size()); });
  parallelRanges(uses.order.size(), kVerticesPerTask, [&](const auto& range) {
    context_.checkCancelled();
    for (std::size_t v = range.begin(); v != range.end(); ++v) result.vertices[v] = mesh_.vertices[uses.order[v]];
  });
  result.layerCount = given_.layerCount;
  for (MeshLink link : given_.links) {
    for (Index* v : {&link.from[0], &link.from[1], &link.to[0], &link.to[1]}) *v = uses.numbers[*v];
    result.links.push_back(link);
  }
  std::sort(result.links.begin(), result.links.end());
  return result;
}

}  // namespace footfall::detail
