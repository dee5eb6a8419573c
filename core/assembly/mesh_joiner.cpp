// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/mesh_joiner.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/base/sorted_list.hpp"
#include "core/mesh/first_uses.hpp"
#include "core/mesh/triangle_split.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 1 << 16;
constexpr std::size_t kSplitsPerTask = 64;
constexpr std::size_t kVerticesPerTask = 1024;
constexpr std::size_t kTrianglesPerBlock = 2048;

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
  const double bound = (p.error + q.error + (std::fabs(u) + std::fabs(v)) * kCoordinateRounding) * kInflate;
  if (u - v > bound) return 1;
  if (u - v < -bound) return -1;
  return exactly ? kernel_.compare(p.point, q.point, axis, mesh_.triangles[p.face][0], count) : 0;
}

int MeshJoiner::compareAlong(const Outline& outline, Index a, Index b, ExactFallbacks& count) const {
  // The axis along which the ends differ for certain, the longer one if doubles can decide.
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

bool MeshJoiner::isFar(Index vertex, Index from, Index to) const {
  const MeshVertex &p = vertices_[vertex], &a = vertices_[from], &b = vertices_[to];
  const double error = (p.error + a.error + b.error) * 2;
  const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z}, w{p.x - a.x, p.y - a.y, p.z - a.z};
  const std::array<double, 3> size{std::fabs(a.x) + std::fabs(b.x) + std::fabs(p.x),
                                   std::fabs(a.y) + std::fabs(b.y) + std::fabs(p.y),
                                   std::fabs(a.z) + std::fabs(b.z) + std::fabs(p.z)};
  for (int i = 0; i < 3; ++i) {
    const int j = next(i);
    const double left = u[i] * w[j], right = u[j] * w[i];
    const double di = error + size[i] * kCoordinateRounding, dj = error + size[j] * kCoordinateRounding;
    const double bound = ((std::fabs(u[i]) + std::fabs(w[i])) * dj + (std::fabs(u[j]) + std::fabs(w[j])) * di +
                          2 * di * dj + (std::fabs(left) + std::fabs(right)) * kCoordinateRounding) *
                             kInflate +
                         kernel_.sign().slack;
    if (std::fabs(left - right) > bound) return true;
  }
  return false;
}

MeshJoiner::Relation MeshJoiner::relate(Index vertex, const Outline& outline, ExactFallbacks& count) const {
  const MeshVertex& p = vertices_[vertex];
  if (outline.sourceEdge.first < 0 || !liesOnSourceEdge(p, outline.sourceEdge)) {
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

// Vertices that are one are the first of them from here on.
void MeshJoiner::uniteVertices(RunContext& context) {
  if (memory_.equal.empty()) return;
  DisjointSets sets(vertices_.size());
  for (const auto& [a, b] : memory_.equal) sets.unite(a, b);
  sameAs_.resize(vertices_.size());
  for (Index v = 0; v < static_cast<Index>(sameAs_.size()); ++v) {
    if (static_cast<std::size_t>(v) % kPolled == 0) context.checkCancelled();
    sameAs_[v] = sets.find(v);
  }
}

std::vector<MeshJoiner::Split> MeshJoiner::findSplits(RunContext& context) {
  std::vector<Incidence> between = memory_.between;
  parallelSort(between.begin(), between.end(), [](const Incidence& a, const Incidence& b) {
    return a.outline != b.outline ? a.outline < b.outline : a.vertex < b.vertex;
  });
  std::vector<std::size_t> first;  // start of each outline
  for (std::size_t i = 0; i < between.size(); ++i)
    if (i == 0 || between[i].outline != between[i - 1].outline) first.push_back(i);
  std::vector<Split> splits(first.size());
  first.push_back(between.size());
  PerThread<ExactFallbacks> fallbacks;
  forRanges(splits.size(), kSplitsPerTask, [&](std::size_t begin, std::size_t end) {
    context.checkCancelled();
    ExactFallbacks& count = fallbacks.local();
    for (std::size_t s = begin; s < end; ++s) {
      const Outline o = outlineOf(between[first[s]].outline);
      std::vector<Index> on;
      for (std::size_t i = first[s]; i < first[s + 1]; ++i) on.push_back(firstAt(between[i].vertex));
      sortOnce(on);
      std::sort(on.begin(), on.end(), [&](Index a, Index b) { return compareAlong(o, a, b, count) < 0; });
      splits[s] = {o.triangle, o.k, std::move(on)};
    }
  });
  for (const ExactFallbacks& count : fallbacks) fallbacks_ += count;
  std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
    return a.triangle != b.triangle ? a.triangle < b.triangle : a.k < b.k;
  });
  return splits;
}

// Vertices that split triangles add this many triangles before each block.
std::vector<MeshTriangle> MeshJoiner::splitTriangles(std::span<const Split> splits, RunContext& context) const {
  std::vector<std::size_t> firstSplit;  // start of each block of triangles
  std::vector<std::size_t> addedBefore;
  std::size_t split = 0, added = 0;
  for (std::size_t t = 0; t < triangles_.size(); t += kTrianglesPerBlock) {
    for (; split < splits.size() && static_cast<std::size_t>(splits[split].triangle) < t; ++split)
      added += splits[split].inner.size();
    firstSplit.push_back(split);
    addedBefore.push_back(added);
  }
  for (; split < splits.size(); ++split) added += splits[split].inner.size();
  std::vector<MeshTriangle> result(triangles_.size() + added);
  parallelFor(firstSplit.size(), [&](std::size_t block) {
    context.checkCancelled();
    const std::size_t first = block * kTrianglesPerBlock;
    auto next = splits.begin() + static_cast<std::ptrdiff_t>(firstSplit[block]);
    auto place = result.begin() + static_cast<std::ptrdiff_t>(first + addedBefore[block]);
    std::vector<MeshTriangle> pieces;
    for (std::size_t t = first; t < std::min(first + kTrianglesPerBlock, triangles_.size()); ++t) {
      MeshTriangle triangle = triangles_[t];
      for (Index& v : triangle.corners) v = firstAt(v);
      if (next == splits.end() || next->triangle != static_cast<Index>(t)) {
        *place++ = triangle;
        continue;
      }
      EdgeVertices on{};
      for (; next != splits.end() && next->triangle == static_cast<Index>(t); ++next) on[next->k] = &next->inner;
      pieces.clear();
      splitTriangle(triangle, on, pieces);
      place = std::copy(pieces.begin(), pieces.end(), place);
    }
  });
  return result;
}

// Triangles with what splits them; vertices in the order of their first use.
WalkableMesh MeshJoiner::assemble(std::span<const Split> splits, RunContext& context) {
  WalkableMesh mesh;
  mesh.triangles = splitTriangles(splits, context);
  triangles_ = {};
  const FirstUses uses = findFirstUses(
      mesh.triangles.size(), vertices_.size(), [&](std::size_t t) { return mesh.triangles[t].corners; }, context);
  parallelInvoke([&] { renumber(mesh.triangles, uses, context); }, [&] { mesh.vertices.resize(uses.order.size()); });
  forRanges(uses.order.size(), kVerticesPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    for (std::size_t v = first; v < last; ++v) mesh.vertices[v] = vertices_[uses.order[v]];
  });
  return mesh;
}

WalkableMesh MeshJoiner::join(RunContext& context) {
  memory_.vertexCount = static_cast<Index>(vertices_.size());
  findIncidences(context);
  context.checkCancelled();
  uniteVertices(context);
  const std::vector<Split> splits = findSplits(context);
  outlines_ = {};
  firstTriangle_ = {};
  context.checkCancelled();
  return assemble(splits, context);
}

JoinMemory MeshJoiner::takeMemory() { return std::move(memory_); }

}  // namespace footfall::detail
