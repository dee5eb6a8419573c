// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/mesh_joiner.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/filters/disjoint_sets.hpp"
#include "core/filters/triangle_split.hpp"

namespace footfall {
namespace {

int next(int k) { return k == 2 ? 0 : k + 1; }

// Rounding of a scaled sum or product of coordinates, generously.
constexpr double kRounding = 8 * 0x1p-53;

std::uint64_t pairKey(Index a, Index b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

}  // namespace

MeshJoiner::MeshJoiner(const PlanKernel& kernel)
    : kernel_(kernel), mesh_(kernel.mesh()), ofSource_(kernel.mesh().vertices.size(), -1) {}

Index MeshJoiner::sourceVertex(Index source, Index face) {
  if (ofSource_[source] < 0) {
    ofSource_[source] = static_cast<Index>(vertices_.size());
    const Vec3& p = mesh_.scaled[source];
    vertices_.push_back(
        {{PlanPoint::Source, mesh_.planIds[source]}, face, source, p.x, p.y, p.z, kernel_.sign().slack});
  }
  return ofSource_[source];
}

Index MeshJoiner::constructedVertex(Index face, const PlanPoint& point, const ApproximatePoint& approximate) {
  if (point.kind == PlanPoint::Source) {
    // an obstacle's vertex seen from above: it may itself lie on the floor
    for (Index v = point.a; v < static_cast<Index>(mesh_.planIds.size()) && mesh_.planIds[v] == point.a; ++v)
      if (kernel_.heightSign(face, v, 0, fallbacks_) == 0) return sourceVertex(v, face);
  }
  std::vector<Index>* same = nullptr;
  const auto& f = mesh_.triangles[face];
  const auto isCorner = [&](Index v) { return f[0] == v || f[1] == v || f[2] == v; };
  if (point.kind == PlanPoint::EdgePlane &&
      ((isCorner(point.a) && isCorner(point.b)) || (point.c == face && point.d == 0))) {
    // In space it lies on the source edge itself, so all faces that know it by this name mean the same vertex.
    same = &onSourceEdges_[pairKey(point.a, point.b)];
    for (const Index v : *same)
      if (vertices_[v].point == point) return v;
  }
  const Vec3& origin = mesh_.scaled[f[0]];
  const auto& n = mesh_.normals[face];
  const ErrorDouble x(approximate.x, approximate.error), y(approximate.y, approximate.error);
  const ErrorDouble gx = x + ErrorDouble(origin.x), gy = y + ErrorDouble(origin.y);
  const ErrorDouble gz = ErrorDouble(origin.z) - (n[0] * x + n[1] * y) / n[2];
  MeshVertex vertex{point, face, -1, gx.value, gy.value, gz.value, 0};
  vertex.error = std::max({gx.error, gy.error, gz.error}) + kernel_.sign().slack;
  const auto index = static_cast<Index>(vertices_.size());
  vertices_.push_back(vertex);
  if (same != nullptr) same->push_back(index);
  return index;
}

void MeshJoiner::addWholeFace(Index face, std::uint8_t obstacleEdges) {
  const auto& f = mesh_.triangles[face];
  MeshTriangle t;
  t.face = face;
  t.obstacleEdges = obstacleEdges;
  for (int k = 0; k < 3; ++k) t.corners[k] = sourceVertex(f[k], face);
  const auto index = static_cast<Index>(triangles_.size());
  triangles_.push_back(t);
  for (int k = 0; k < 3; ++k) {
    const Index u = f[k], v = f[next(k)];
    const Index a = mesh_.planIds[u], b = mesh_.planIds[v];
    outlines_.push_back({t.corners[k],
                         t.corners[next(k)],
                         index,
                         static_cast<std::int8_t>(k),
                         face,
                         {PlanLine::Edge, std::min(a, b), std::max(a, b)},
                         {std::min(u, v), std::max(u, v)}});
  }
}

void MeshJoiner::addParts(Index face, const FaceMesh& parts) {
  const auto& f = mesh_.triangles[face];
  std::vector<Index> vertexOf(parts.points.size(), -1);
  for (const FaceMesh::Cell& cell : parts.cells) {
    MeshTriangle t;
    t.face = face;
    t.obstacleEdges = cell.obstacleEdges;
    for (int k = 0; k < 3; ++k) {
      const Index p = cell.corners[k];
      if (vertexOf[p] < 0)
        vertexOf[p] = p < 3 ? sourceVertex(f[p], face) : constructedVertex(face, parts.points[p], parts.approximate[p]);
      t.corners[k] = vertexOf[p];
    }
    const auto index = static_cast<Index>(triangles_.size());
    triangles_.push_back(t);
    for (int k = 0; k < 3; ++k) {
      if ((cell.outlineEdges >> k & 1) == 0) continue;
      Outline outline{t.corners[k], t.corners[next(k)],         index,   static_cast<std::int8_t>(k),
                      face,         parts.lines[cell.lines[k]], {-1, -1}};
      if (cell.faceEdges[k] >= 0) {
        const Index u = f[cell.faceEdges[k]], v = f[next(cell.faceEdges[k])];
        outline.sourceEdge = {std::min(u, v), std::max(u, v)};
      }
      outlines_.push_back(outline);
    }
  }
}

bool MeshJoiner::liesOnSourceEdge(const MeshVertex& vertex, const std::pair<Index, Index>& edge) const {
  if (vertex.source >= 0) return vertex.source == edge.first || vertex.source == edge.second;
  const PlanPoint& p = vertex.point;
  if (p.kind != PlanPoint::EdgePlane || p.a != edge.first || p.b != edge.second) return false;
  const auto& f = mesh_.triangles[vertex.face];
  const auto isCorner = [&](Index v) { return f[0] == v || f[1] == v || f[2] == v; };
  return (isCorner(p.a) && isCorner(p.b)) || (p.c == vertex.face && p.d == 0);
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

void MeshJoiner::findIncidences(RunContext& context, std::vector<Incidence>& between,
                                std::vector<std::pair<Index, Index>>& equal) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids(outlines_.size());
  std::iota(ids.begin(), ids.end(), 0);
  boxes.reserve(outlines_.size());
  std::vector<char> onOutline(vertices_.size(), 0);
  const auto boxOf = [&](const MeshVertex& v) {
    const double r = v.error;
    const auto low = [&](double c) { return c - r - std::fabs(c) * kRounding; };
    const auto high = [&](double c) { return c + r + std::fabs(c) * kRounding; };
    return Box{{low(v.x), low(v.y), low(v.z)}, {high(v.x), high(v.y), high(v.z)}};
  };
  for (const Outline& o : outlines_) {
    onOutline[o.from] = onOutline[o.to] = 1;
    Box box = boxOf(vertices_[o.from]);
    const Box other = boxOf(vertices_[o.to]);
    for (int k = 0; k < 3; ++k) {
      box.lower[k] = std::min(box.lower[k], other.lower[k]);
      box.upper[k] = std::max(box.upper[k], other.upper[k]);
    }
    boxes.push_back(box);
  }
  TriangleTree tree;
  tree.build(std::move(boxes), std::move(ids), [&context] { context.checkCancelled(); });

  struct Local {
    std::vector<Incidence> between;
    std::vector<std::pair<Index, Index>> equal;
    std::vector<std::int32_t> stack;
    ExactFallbacks fallbacks;
  };
  tbb::enumerable_thread_specific<Local> locals;
  tbb::parallel_for(tbb::blocked_range<Index>(0, static_cast<Index>(vertices_.size()), 512), [&](const auto& range) {
    context.checkCancelled();
    Local& local = locals.local();
    for (Index v = range.begin(); v != range.end(); ++v) {
      if (onOutline[v] == 0) continue;
      tree.visitOverlapping(boxOf(vertices_[v]), local.stack, [&](std::int32_t i) {
        const Outline& o = outlines_[i];
        if (o.from == v || o.to == v) return true;
        const Relation relation = relate(v, o, local.fallbacks);
        if (relation == Relation::Between) local.between.push_back({i, v});
        if (relation == Relation::AtStart) local.equal.emplace_back(v, o.from);
        if (relation == Relation::AtEnd) local.equal.emplace_back(v, o.to);
        return true;
      });
    }
  });
  for (Local& local : locals) {
    between.insert(between.end(), local.between.begin(), local.between.end());
    equal.insert(equal.end(), local.equal.begin(), local.equal.end());
    fallbacks_ += local.fallbacks;
  }
}

void MeshJoiner::splitTriangles(const std::vector<std::vector<Index>>& splits,
                                const std::unordered_map<std::uint64_t, Index>& splitOf,
                                std::vector<MeshTriangle>& result) const {
  for (Index t = 0; t < static_cast<Index>(triangles_.size()); ++t) {
    EdgeVertices on{};
    for (int k = 0; k < 3; ++k)
      if (const auto it = splitOf.find(pairKey(t, k)); it != splitOf.end()) on[k] = &splits[it->second];
    splitTriangle(triangles_[t], on, result);
  }
}

WalkableMesh MeshJoiner::join(RunContext& context) {
  std::vector<Incidence> between;
  std::vector<std::pair<Index, Index>> equal;
  findIncidences(context, between, equal);
  context.checkCancelled();

  DisjointSets sets(vertices_.size());
  for (const auto& [a, b] : equal) sets.unite(a, b);
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
  std::unordered_map<std::uint64_t, Index> splitOf;
  for (std::size_t i = 0; i < between.size();) {
    const Outline& o = outlines_[between[i].outline];
    std::vector<Index> on;
    std::size_t j = i;
    for (; j < between.size() && between[j].outline == between[i].outline; ++j) on.push_back(between[j].vertex);
    std::sort(on.begin(), on.end(), [&](Index a, Index b) { return compareAlong(o, a, b, fallbacks_) < 0; });
    splitOf[pairKey(o.triangle, o.k)] = static_cast<Index>(splits.size());
    splits.push_back(std::move(on));
    i = j;
  }
  context.checkCancelled();
  for (MeshTriangle& t : triangles_)
    for (Index& v : t.corners) v = sets.find(v);

  WalkableMesh mesh;
  mesh.triangles.reserve(triangles_.size() + 2 * between.size());
  splitTriangles(splits, splitOf, mesh.triangles);
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

}  // namespace footfall
