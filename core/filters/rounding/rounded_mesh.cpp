// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/rounded_mesh.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/base/geometry.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

// An edge shorter than this share of its coordinates is one that rounding can have folded; longer ones are never
// collapsed while another repair is possible.
constexpr double kFoldedShare = 0x1p-44;

constexpr Index kTrianglesPerTask = 4096;

/// The triangles around each vertex, in the order in which they came there. Only few vertices are ever asked for, so
/// lists are made when they are.
class Surroundings {
 public:
  void build(const std::vector<MeshTriangle>& triangles, std::size_t vertexCount) {
    first_.assign(vertexCount + 1, 0);
    for (const MeshTriangle& t : triangles)
      for (const Index v : t.corners) ++first_[v + 1];
    for (std::size_t v = 0; v < vertexCount; ++v) first_[v + 1] += first_[v];
    atStart_.resize(triangles.size() * 3);
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
      for (const Index v : triangles[t].corners) atStart_[next[v]++] = t;
  }
  /// References stay valid.
  std::vector<Index>& operator[](Index vertex) {
    const auto [it, isNew] = lists_.try_emplace(vertex);
    if (isNew) it->second.assign(atStart_.begin() + first_[vertex], atStart_.begin() + first_[vertex + 1]);
    return it->second;
  }

 private:
  std::vector<Index> first_, atStart_;
  std::unordered_map<Index, std::vector<Index>> lists_;
};

class RoundingRepair {
 public:
  RoundingRepair(RoundedMesh& mesh, const std::vector<char>& sturdy) : mesh_(mesh), sturdy_(sturdy) {}

  RoundingCases run(RunContext& context) {
    const auto count = static_cast<Index>(mesh_.triangles.size());
    std::vector<char> broken(count);
    std::atomic<std::uint64_t> exact{0};
    tbb::parallel_for(tbb::blocked_range<Index>(0, count, kTrianglesPerTask), [&](const auto& range) {
      context.checkCancelled();
      std::uint64_t exactHere = 0;
      for (Index t = range.begin(); t != range.end(); ++t) {
        const auto& c = mesh_.triangles[t].corners;
        exactHere += sturdy_[c[0]] != 0 && sturdy_[c[1]] != 0 && sturdy_[c[2]] != 0;
        broken[t] = static_cast<char>(!isUpright(t));
      }
      exact.fetch_add(exactHere, std::memory_order_relaxed);
    });
    RoundingCases cases;
    cases.exact = exact;
    std::vector<Index> queue;
    for (Index t = 0; t < count; ++t) {
      if (broken[t] == 0) continue;
      this->count(t, cases);
      queue.push_back(t);
    }
    if (queue.empty()) return cases;
    alive_.assign(mesh_.triangles.size(), 1);
    around_.build(mesh_.triangles, mesh_.vertices.size());
    // A flip can be undone by a later one; after so many repairs only collapses are used, and each takes a vertex away.
    std::size_t gentle = 16 * queue.size() + 1024;
    while (!queue.empty()) {
      context.checkCancelled();
      const Index t = queue.back();
      queue.pop_back();
      if (alive_[t] == 0 || isUpright(t)) continue;
      changed_.clear();
      repair(t, gentle > 0);
      if (gentle > 0) --gentle;
      for (const Index c : changed_)
        if (alive_[c] != 0 && !isUpright(c)) queue.push_back(c);
    }
    compact();
    cases.collapsed = std::move(collapsed_);
    return cases;
  }

 private:
  const Vec3& place(Index v) const { return mesh_.vertices[v]; }
  [[nodiscard]] bool isUpright(Index t) const {
    const auto& c = mesh_.triangles[t].corners;
    const Vec3 &p = place(c[0]), &q = place(c[1]), &r = place(c[2]);
    // Differences, products and the last difference lose at most 4 u (|l| + |r|) together, u = 2^-53, and the bound 2 u
    // more; underflows lose less than 2^-1000. An overflow makes the bound infinite or NaN.
    const double left = (q.x - p.x) * (r.y - p.y), right = (q.y - p.y) * (r.x - p.x);
    if (left - right > (std::fabs(left) + std::fabs(right)) * 0x1p-50 + 0x1p-1000) return true;
    return facing(p, q, r) > 0;
  }

  void count(Index t, RoundingCases& cases) const {
    const auto& c = mesh_.triangles[t].corners;
    const Vec3 &p = place(c[0]), &q = place(c[1]), &r = place(c[2]);
    const int equal = (p == q) + (q == r) + (r == p);
    if (equal == 3)
      ++cases.point;
    else if (equal == 1)
      ++cases.edge;
    else if (facing(p, q, r) == 0)
      ++cases.collinear;
    else
      ++cases.flipped;
  }

  [[nodiscard]] double squaredLength(Index a, Index b) const {
    const double dx = place(a).x - place(b).x, dy = place(a).y - place(b).y, dz = place(a).z - place(b).z;
    return dx * dx + dy * dy + dz * dz;
  }
  [[nodiscard]] bool isFolded(Index a, Index b) const {
    const Vec3& p = place(a);
    const double size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) * kFoldedShare;
    return squaredLength(a, b) <= size * size;
  }

  // The triangle with the edge from a to b.
  [[nodiscard]] Index across(Index a, Index b, int& k) {
    for (const Index t : around_[a]) {
      if (alive_[t] == 0) continue;
      for (k = 0; k < 3; ++k)
        if (mesh_.triangles[t].corners[k] == a && mesh_.triangles[t].corners[next(k)] == b) return t;
    }
    return -1;
  }

  void repair(Index t, bool gentle) {
    const MeshTriangle triangle = mesh_.triangles[t];
    const auto& c = triangle.corners;
    int longest = 0, shortest = 0;
    for (int k = 1; k < 3; ++k) {
      const double length = squaredLength(c[k], c[next(k)]);
      if (length > squaredLength(c[longest], c[next(longest)])) longest = k;
      if (length < squaredLength(c[shortest], c[next(shortest)])) shortest = k;
    }
    if (gentle && !isFolded(c[shortest], c[next(shortest)])) {
      int k = 0;
      Index other = across(c[next(longest)], c[longest], k);
      if ((triangle.obstacleEdges >> longest & 1) != 0) other = -1;
      if (other >= 0 && (mesh_.triangles[other].obstacleEdges >> k & 1) != 0) other = -1;
      if (other < 0) {
        drop(t, longest);
        return;
      }
      if (!isUpright(other)) {  // a needle beside a needle: the neighbour goes first
        if (!flip(t, longest, other, k, false)) changed_.insert(changed_.end(), {t, other});
        return;
      }
      // Where the neighbour is a needle too, one of the two new triangles may be turned over, and goes on from there.
      if (flip(t, longest, other, k, true)) return;
    }
    collapse(c[shortest], c[next(shortest)]);
  }

  // A triangle whose longest edge is a border: its other edges become the border.
  void drop(Index t, int border) {
    const MeshTriangle triangle = mesh_.triangles[t];
    alive_[t] = 0;
    if ((triangle.obstacleEdges >> border & 1) == 0) return;
    for (const int k : {next(border), previous(border)}) markOpposite(triangle.corners[k], triangle.corners[next(k)]);
  }

  void markOpposite(Index a, Index b) {
    int k = 0;
    if (const Index other = across(b, a, k); other >= 0)
      mesh_.triangles[other].obstacleEdges |= static_cast<std::uint8_t>(1 << k);
  }

  // Hands the corner opposite t's edge k to the neighbour there: the edge is turned. Unless forced, only if both new
  // triangles face up.
  bool flip(Index t, int k, Index other, int j, bool forced) {
    const MeshTriangle x = mesh_.triangles[t], y = mesh_.triangles[other];
    const Index a = x.corners[k], b = x.corners[next(k)], c = x.corners[previous(k)], d = y.corners[previous(j)];
    if (c == d) return false;  // the same triangle seen from both sides
    if (!forced && (facing(place(c), place(a), place(d)) <= 0 || facing(place(c), place(d), place(b)) <= 0))
      return false;
    const auto flag = [](const MeshTriangle& m, int edge) { return m.obstacleEdges >> edge & 1; };
    MeshTriangle p{{c, a, d}, y.face, 0}, q{{c, d, b}, y.face, 0};
    p.obstacleEdges = static_cast<std::uint8_t>(flag(x, previous(k)) | flag(y, next(j)) << 1);
    q.obstacleEdges = static_cast<std::uint8_t>(flag(y, previous(j)) << 1 | flag(x, next(k)) << 2);
    mesh_.triangles[t] = p;
    mesh_.triangles[other] = q;
    if (!mesh_.layers.empty()) mesh_.layers[t] = mesh_.layers[other];
    around_[d].push_back(t);
    around_[c].push_back(other);
    std::erase(around_[b], t);
    std::erase(around_[a], other);
    changed_.insert(changed_.end(), {t, other});
    return true;
  }

  void collapse(Index a, Index b) {
    if (sturdy_[b] != 0 && sturdy_[a] == 0) std::swap(a, b);
    if (sturdy_[a] == sturdy_[b] && b < a) std::swap(a, b);  // b goes to a
    collapsed_.push_back({b, a});
    const std::vector<Index> ring = around_[b];
    for (const Index t : ring) {
      if (alive_[t] == 0) continue;
      MeshTriangle& m = mesh_.triangles[t];
      const bool folds = m.corners[0] == a || m.corners[1] == a || m.corners[2] == a;
      if (!folds) continue;
      alive_[t] = 0;
      for (int k = 0; k < 3; ++k)
        if ((m.obstacleEdges >> k & 1) != 0) {
          const Index u = m.corners[k] == b ? a : m.corners[k], v = m.corners[next(k)] == b ? a : m.corners[next(k)];
          if (u == v) continue;
          markOpposite(m.corners[k], m.corners[next(k)]);
          // the two edges that fall together are one obstacle edge now
          const Index third = u == a ? v : u;
          for (const Index end : {a, b}) {
            markOpposite(end, third);
            markOpposite(third, end);
          }
        }
    }
    for (const Index t : ring) {
      if (alive_[t] == 0) continue;
      for (Index& v : mesh_.triangles[t].corners)
        if (v == b) v = a;
      around_[a].push_back(t);
      changed_.push_back(t);
    }
    around_[b].clear();
  }

  void compact() {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (alive_[t] == 0) continue;
      if (!mesh_.layers.empty()) mesh_.layers[kept] = mesh_.layers[t];
      mesh_.triangles[kept++] = mesh_.triangles[t];
    }
    mesh_.triangles.resize(kept);
    if (!mesh_.layers.empty()) mesh_.layers.resize(kept);
  }

  RoundedMesh& mesh_;
  const std::vector<char>& sturdy_;
  std::vector<char> alive_;
  Surroundings around_;
  std::vector<Index> changed_;
  std::vector<std::array<Index, 2>> collapsed_;
};

}  // namespace

std::vector<Vec3> roundVertices(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices,
                                std::vector<char>& exact, RunContext& context) {
  std::vector<Vec3> places(vertices.size());
  exact.assign(vertices.size(), 1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 256), [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      if (vertices[v].source >= 0) {
        places[v] = kernel.mesh().vertices[vertices[v].source];
        continue;
      }
      bool isExact = true;
      places[v] = kernel.roundedPosition(vertices[v].point, vertices[v].face, &isExact);
      exact[v] = static_cast<char>(isExact);
    }
  });
  return places;
}

RoundingCases repairRounding(RoundedMesh& mesh, const std::vector<char>& sturdy, RunContext& context) {
  return RoundingRepair(mesh, sturdy).run(context);
}

}  // namespace footfall::detail
