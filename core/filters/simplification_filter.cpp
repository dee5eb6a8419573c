// SimplificationFilter: each coplanar region with as few triangles as its outline needs (design section 2, thesis 3.2
// and 5.1.2).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices are taken away one by one: those inside a coplanar region, and those in the middle of a straight piece of
// its outline. The hole around a vertex is star-shaped, so ears can be cut off it by looking at three corners only
// (O. Devillers, "On deletion in Delaunay triangulations", 1999). What is left has no vertex that could go, and the
// number of triangles follows from Euler's formula. A last pass flips edges inside regions towards Delaunay.
#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "core/filters/disjoint_sets.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/mesh_assembly.hpp"
#include "core/filters/mesh_geometry.hpp"
#include "core/filters/mesh_topology.hpp"

namespace footfall {
namespace {

int next(int k) { return k == 2 ? 0 : k + 1; }
int previous(int k) { return k == 0 ? 2 : k - 1; }

class Simplifier {
 public:
  Simplifier(const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context)
      : kernel_(kernel), context_(context), geometry_(kernel, mesh.vertices), mesh_(mesh) {}

  WalkableMesh run() {
    findInnerEdges();
    around_.resize(mesh_.vertices.size());
    for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t)
      for (const Index v : mesh_.triangles[t].corners) around_[v].push_back(t);
    alive_.assign(mesh_.triangles.size(), 1);
    for (Index v = 0; v < static_cast<Index>(mesh_.vertices.size()); ++v) {
      if ((v & 255) == 0) context_.checkCancelled();
      if ((v & 8191) == 0) context_.progress(static_cast<double>(v) / static_cast<double>(mesh_.vertices.size()));
      removeIfPossible(v);
    }
    improve();
    return compact();
  }

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return geometry_.fallbacks; }

 private:
  /// The triangles at a vertex between two outline edges, or all around it.
  struct Fan {
    std::vector<Index> triangles;
    std::vector<Index> ring;  ///< opposite vertices, counter-clockwise; a closed fan does not repeat the first
    bool closed = false;
    int firstFlag = 0, lastFlag = 0;   ///< obstacle flags of the first and the last outline edge
    std::vector<Index> ringNeighbors;  ///< for each ring edge the side beyond it, or -1
    std::vector<int> ringFlags;        ///< and its obstacle flag
  };

  void findInnerEdges() {
    neighbors_.assign(mesh_.triangles.size() * 3, -1);
    const MeshTopology topology = findEdges(mesh_);
    DisjointSets planes(kernel_.mesh().triangles.size());
    for (const MeshEdge& e : topology.edges) {
      if (e.useCount != 2 || e.obstacle) continue;
      const Index s = topology.uses[e.firstUse], t = topology.uses[e.firstUse + 1];
      if (!mesh_.layers.empty() && mesh_.layers[s / 3] != mesh_.layers[t / 3]) continue;
      const Index f = mesh_.triangles[s / 3].face, g = mesh_.triangles[t / 3].face;
      if (planes.find(f) != planes.find(g)) {
        if (!kernel_.coplanar(f, g, geometry_.fallbacks)) continue;
        planes.unite(f, g);
      }
      if (mesh_.triangles[s / 3].corners[s % 3] == mesh_.triangles[t / 3].corners[t % 3]) continue;  // folded over
      neighbors_[s] = t;
      neighbors_[t] = s;
    }
  }

  [[nodiscard]] int cornerOf(Index t, Index v) const {
    const auto& c = mesh_.triangles[t].corners;
    return c[0] == v ? 0 : c[1] == v ? 1 : 2;
  }

  // All fans around v; false when some triangle was met twice.
  void collectFans(Index v, std::vector<Fan>& fans) {
    fans.clear();
    auto& list = around_[v];
    std::erase_if(list, [&](Index t) { return alive_[t] == 0 || !hasCorner(t, v); });
    std::vector<Index> left(list.begin(), list.end());
    std::sort(left.begin(), left.end());
    left.erase(std::unique(left.begin(), left.end()), left.end());
    while (!left.empty()) {
      // go clockwise to the first triangle of its fan
      Index first = left.front();
      bool closed = false;
      for (;;) {
        const Index side = neighbors_[3 * first + cornerOf(first, v)];  // edge v -> next
        if (side < 0) break;
        first = side / 3;
        if (first == left.front()) {
          closed = true;
          break;
        }
      }
      Fan fan;
      fan.closed = closed;
      Index t = first;
      for (;;) {
        const int i = cornerOf(t, v);
        const MeshTriangle& m = mesh_.triangles[t];
        fan.triangles.push_back(t);
        fan.ring.push_back(m.corners[next(i)]);
        fan.ringNeighbors.push_back(neighbors_[3 * t + next(i)]);
        fan.ringFlags.push_back(m.obstacleEdges >> next(i) & 1);
        if (t == first) fan.firstFlag = m.obstacleEdges >> i & 1;
        const Index side = neighbors_[3 * t + previous(i)];  // edge previous -> v
        if (side < 0) {
          fan.ring.push_back(m.corners[previous(i)]);
          fan.lastFlag = m.obstacleEdges >> previous(i) & 1;
          break;
        }
        t = side / 3;
        if (t == first) break;
      }
      for (const Index used : fan.triangles) std::erase(left, used);
      fans.push_back(std::move(fan));
    }
  }

  [[nodiscard]] bool hasCorner(Index t, Index v) const {
    const auto& c = mesh_.triangles[t].corners;
    return c[0] == v || c[1] == v || c[2] == v;
  }

  void removeIfPossible(Index v) {
    collectFans(v, fans_);
    if (fans_.empty()) return;
    if (fans_.size() == 1 && fans_[0].closed) {
      fill(v, fans_[0]);
      return;
    }
    const Index u = fans_[0].ring.front(), w = fans_[0].ring.back();
    for (const Fan& fan : fans_) {
      if (fan.closed) return;
      const Index a = fan.ring.front(), b = fan.ring.back();
      if (!((a == u && b == w) || (a == w && b == u))) return;
      if (fan.firstFlag != fan.lastFlag) return;
    }
    if (!geometry_.isBetween(u, v, w)) return;
    for (const Fan& fan : fans_) fill(v, fan);
  }

  // Replaces the triangles of a fan by triangles of its ring alone.
  void fill(Index v, const Fan& fan) {
    std::vector<Index> ring = fan.ring;
    std::vector<Index> sides = fan.ringNeighbors;  // beyond the edge from ring[i] to ring[i + 1]
    std::vector<int> flags = fan.ringFlags;
    if (!fan.closed) {
      sides.push_back(-1);
      flags.push_back(fan.firstFlag);
    }
    Index face = mesh_.triangles[fan.triangles[0]].face;
    for (const Index t : fan.triangles) {
      face = std::min(face, mesh_.triangles[t].face);
      alive_[t] = 0;
    }
    std::size_t slot = 0;
    const auto place = [&](Index a, Index b, Index c, std::array<Index, 3> beyond, std::array<int, 3> flag) {
      const Index t = fan.triangles[slot++];
      alive_[t] = 1;
      mesh_.triangles[t] = {{a, b, c}, face, static_cast<std::uint8_t>(flag[0] | flag[1] << 1 | flag[2] << 2)};
      for (int k = 0; k < 3; ++k) {
        neighbors_[3 * t + k] = beyond[k];
        if (beyond[k] >= 0) neighbors_[beyond[k]] = 3 * t + k;
        around_[mesh_.triangles[t].corners[k]].push_back(t);
      }
      return t;
    };
    std::size_t i = 0, misses = 0;
    while (ring.size() > 3) {
      const std::size_t n = ring.size(), before = (i + n - 1) % n, after = (i + 1) % n;
      const Index a = ring[before], b = ring[i], c = ring[after];
      if (geometry_.orientation(a, b, c) > 0 && geometry_.orientation(a, c, v) >= 0) {
        const Index t = place(a, b, c, {sides[before], sides[i], -1}, {flags[before], flags[i], 0});
        sides[before] = 3 * t + 2;
        flags[before] = 0;
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
        sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(i));
        flags.erase(flags.begin() + static_cast<std::ptrdiff_t>(i));
        i = (i + ring.size() - 1) % ring.size();
        misses = 0;
      } else {
        i = after;
        if (++misses > ring.size()) throw std::logic_error("simplification found a hole without an ear");
      }
    }
    place(ring[0], ring[1], ring[2], {sides[0], sides[1], sides[2]}, {flags[0], flags[1], flags[2]});
  }

  // Flips edges inside regions while the opposite corner seems to lie well inside the circumcircle.
  void improve() {
    std::vector<Index> queue;
    for (Index s = 0; s < static_cast<Index>(neighbors_.size()); ++s)
      if (alive_[s / 3] != 0 && neighbors_[s] > s) queue.push_back(s);
    std::size_t left = 10 * queue.size();
    while (!queue.empty() && left > 0) {
      if ((left & 255) == 0) context_.checkCancelled();
      const Index s = queue.back();
      queue.pop_back();
      if (neighbors_[s] < 0 || !flipIfBetter(s)) continue;
      --left;
      const Index t = s / 3, other = neighbors_[3 * t + 1] / 3;
      for (const Index m : {t, other})
        for (int k = 0; k < 3; ++k)
          if (neighbors_[3 * m + k] >= 0) queue.push_back(3 * m + k);
    }
  }

  bool flipIfBetter(Index s) {
    const Index o = neighbors_[s];
    const Index t = s / 3, u = o / 3;
    const int k = s % 3, j = o % 3;
    const MeshTriangle x = mesh_.triangles[t], y = mesh_.triangles[u];
    const Index a = x.corners[k], b = x.corners[next(k)], c = x.corners[previous(k)], d = y.corners[previous(j)];
    const auto relative = [&](Index v) {
      return std::array<double, 2>{mesh_.vertices[v].x - mesh_.vertices[d].x,
                                   mesh_.vertices[v].y - mesh_.vertices[d].y};
    };
    const auto [ax, ay] = relative(a);
    const auto [bx, by] = relative(b);
    const auto [cx, cy] = relative(c);
    const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    const double inside = a2 * (bx * cy - by * cx) + b2 * (cx * ay - cy * ax) + c2 * (ax * by - ay * bx);
    const double size = a2 * (std::fabs(bx * cy) + std::fabs(by * cx)) +
                        b2 * (std::fabs(cx * ay) + std::fabs(cy * ax)) + c2 * (std::fabs(ax * by) + std::fabs(ay * bx));
    if (!(inside > size * 0x1p-32)) return false;  // a margin, so that flips cannot go round in circles
    if (geometry_.orientation(c, a, d) <= 0 || geometry_.orientation(c, d, b) <= 0) return false;
    const auto flag = [](const MeshTriangle& m, int edge) { return m.obstacleEdges >> edge & 1; };
    const Index ca = neighbors_[3 * t + previous(k)], bc = neighbors_[3 * t + next(k)];
    const Index ad = neighbors_[3 * u + next(j)], db = neighbors_[3 * u + previous(j)];
    mesh_.triangles[t] = {{c, a, d}, x.face, static_cast<std::uint8_t>(flag(x, previous(k)) | flag(y, next(j)) << 1)};
    mesh_.triangles[u] = {
        {c, d, b}, y.face, static_cast<std::uint8_t>(flag(y, previous(j)) << 1 | flag(x, next(k)) << 2)};
    const auto link = [&](Index side, Index beyond) {
      neighbors_[side] = beyond;
      if (beyond >= 0) neighbors_[beyond] = side;
    };
    link(3 * t, ca);
    link(3 * t + 1, ad);
    link(3 * t + 2, 3 * u);
    link(3 * u + 1, db);
    link(3 * u + 2, bc);
    return true;
  }

  WalkableMesh compact() {
    WalkableMesh result;
    std::vector<Index> renumbered(mesh_.vertices.size(), -1);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (alive_[t] == 0) continue;
      MeshTriangle m = mesh_.triangles[t];
      for (Index& v : m.corners) {
        if (renumbered[v] < 0) {
          renumbered[v] = static_cast<Index>(result.vertices.size());
          result.vertices.push_back(mesh_.vertices[v]);
        }
        v = renumbered[v];
      }
      result.triangles.push_back(m);
      if (!mesh_.layers.empty()) result.layers.push_back(mesh_.layers[t]);
    }
    result.layerCount = mesh_.layerCount;
    return result;
  }

  const PlanKernel& kernel_;
  RunContext& context_;
  MeshGeometry geometry_;
  WalkableMesh mesh_;
  std::vector<Index> neighbors_;  ///< for each side the side on the other triangle of its region, or -1
  std::vector<std::vector<Index>> around_;
  std::vector<char> alive_;
  std::vector<Fan> fans_;
};

}  // namespace

FilterOutcome applySimplification(const StatePtr& given, bool approximate, double tolerance, RunContext& context) {
  (void)approximate;
  (void)tolerance;
  FilterOutcome outcome;
  const StatePtr state = withMesh(given, context, outcome.fallbacks);
  Simplifier simplifier(*state->kernel, *state->mesh, context);
  auto result = std::make_shared<WalkableState>(*state);
  result->mesh = std::make_shared<WalkableMesh>(simplifier.run());
  outcome.fallbacks += simplifier.fallbacks();
  outcome.state = std::move(result);
  return outcome;
}

}  // namespace footfall
