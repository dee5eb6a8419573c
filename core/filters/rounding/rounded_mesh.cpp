// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/rounded_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/rounding/repaired_mesh.hpp"
#include "core/filters/rounding/snapped_needles.hpp"

namespace footfall::detail {
namespace {

// An edge shorter than this share of its coordinates is one that rounding can have folded; longer ones are never
// collapsed while another repair is possible.
constexpr double kFoldedShare = 0x1p-44;

// No edge goes farther from where it was than this share of the largest coordinate: four edges that rounding folded,
// one behind the other. Vertices of needles are taken for touching an edge within the least reach, or if that does not
// do within more, as far as the largest. A corner that rounding turned over is within 2^-51 of its triangle's edge.
constexpr double kMostDrift = 0x1p-42;
constexpr double kLeastReach = 0x1p-50, kMostReach = 0x1p-44;

constexpr Index kTrianglesPerTask = 1024;

class RoundingRepair {
 public:
  RoundingRepair(RoundedMesh& mesh, const std::vector<char>& sturdy) : rounded_(mesh), mesh_(mesh), sturdy_(sturdy) {}

  RoundingCases run(const std::vector<Index>& crowded, RunContext& context) {
    const auto count = static_cast<Index>(rounded_.triangles.size());
    std::vector<char> broken(count);
    std::atomic<std::uint64_t> exact{0};
    parallelRanges(count, kTrianglesPerTask, [&](const auto& range) {
      context.checkCancelled();
      std::uint64_t exactHere = 0;
      for (Index t = range.begin(); t != range.end(); ++t) {
        const auto& c = rounded_.triangles[t].corners;
        exactHere += sturdy_[c[0]] != 0 && sturdy_[c[1]] != 0 && sturdy_[c[2]] != 0;
        broken[t] = static_cast<char>(!mesh_.isUpright(t));
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
    if (queue.empty() && crowded.empty()) return cases;
    mesh_.start();
    for (const Index t : crowded) {
      if (!mesh_.isUpright(t) || !isBroken(t)) continue;
      queue.push_back(t);
      ++cases.crowded;
    }
    if (cases.crowded != 0 || !repairEach(queue, context)) {
      mesh_.undoAll();
      collapsed_.clear();
      snapAll(queue, context);
    }
    mesh_.compact();
    cases.collapsed = std::move(collapsed_);
    return cases;
  }

 private:
  // One triangle after the other. False where that comes to no end, or drifts too far: nothing of it is to be kept.
  bool repairEach(std::vector<Index> queue, RunContext& context) {
    // A flip can be undone by a later one.
    std::size_t left = 16 * queue.size() + 1024;
    while (!queue.empty()) {
      context.checkCancelled();
      const Index t = queue.back();
      queue.pop_back();
      if (!mesh_.isAlive(t) || mesh_.isUpright(t)) continue;
      changed_.clear();
      if (left-- == 0 || !repair(t)) return false;
      for (const Index c : changed_)
        if (mesh_.isAlive(c) && !mesh_.isUpright(c)) queue.push_back(c);
    }
    return mesh_.isConforming();
  }

  /// Turned over, or a needle that came to lie on the same side of an edge as another triangle.
  [[nodiscard]] bool isBroken(Index t) {
    if (!mesh_.isAlive(t)) return false;
    if (!mesh_.isUpright(t)) return true;
    return heightOver(t, extremeSides(mesh_[t].corners)[1]) <= kMostReach * mesh_.largest() && !mesh_.isConforming(t);
  }

  // Snaps all triangles, with everything that lies near each of them.
  void snapAll(std::vector<Index> queue, RunContext& context) {
    NeedleSnapper snapper(mesh_);
    while (!queue.empty()) {
      context.checkCancelled();
      const Index t = queue.back();
      queue.pop_back();
      if (!isBroken(t)) continue;
      changed_.clear();
      const std::array<Index, 3> c = mesh_[t].corners;
      const int shortest = extremeSides(c)[0];
      if (!(isFolded(c[shortest], c[next(shortest)]) && collapse(c[shortest], c[next(shortest)])) && !snap(t, snapper))
        takeOut(t);
      enqueueChanged(queue);
    }
  }

  bool snap(Index t, NeedleSnapper& snapper) {
    for (double share = kLeastReach; share <= kMostReach; share *= 2)
      for (;;) {
        const NeedleSnapper::Outcome outcome = snapper.snap(t, share * mesh_.largest());
        if (outcome == NeedleSnapper::Outcome::Done) return true;
        if (outcome == NeedleSnapper::Outcome::Failed) break;
        if (!collapse(snapper.together()[0], snapper.together()[1])) return false;
        if (!isBroken(t)) return true;
      }
    return false;
  }

  void enqueueChanged(std::vector<Index>& queue) {
    for (const Index c : changed_)
      for (int k = 0; k < 3 && mesh_.isAlive(c); ++k)
        mesh_.visitSide(mesh_[c].corners[k], mesh_[c].corners[next(k)], [&](Index t) {
          if (isBroken(t)) queue.push_back(t);
        });
  }

  [[nodiscard]] const Vec3& place(Index v) const { return mesh_.place(v); }

  void count(Index t, RoundingCases& cases) const {
    const auto& c = mesh_[t].corners;
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
  // The distance of a triangle's corner from the line of its longest edge, in the plan.
  [[nodiscard]] double heightOver(Index t, int longest) const {
    const auto& c = mesh_[t].corners;
    const Vec3 &a = place(c[longest]), &b = place(c[next(longest)]), &p = place(c[previous(longest)]);
    const double x = b.x - a.x, y = b.y - a.y, length = std::sqrt(x * x + y * y);
    return length > 0 ? std::fabs(x * (p.y - a.y) - y * (p.x - a.x)) / length : 0;
  }
  [[nodiscard]] bool mayDrift(double drift) const { return drift <= kMostDrift * mesh_.largest(); }

  // The shortest and the longest one.
  [[nodiscard]] std::array<int, 2> extremeSides(const std::array<Index, 3>& c) const {
    int longest = 0, shortest = 0;
    for (int k = 1; k < 3; ++k) {
      const double length = squaredLength(c[k], c[next(k)]);
      if (length > squaredLength(c[longest], c[next(longest)])) longest = k;
      if (length < squaredLength(c[shortest], c[next(shortest)])) shortest = k;
    }
    return {shortest, longest};
  }

  bool repair(Index t) {
    const MeshTriangle triangle = mesh_[t];
    const auto& c = triangle.corners;
    const auto [shortest, longest] = extremeSides(c);
    if (isFolded(c[shortest], c[next(shortest)])) return collapse(c[shortest], c[next(shortest)]);
    int k = 0;
    Index other = mesh_.across(c[next(longest)], c[longest], k);
    if ((triangle.obstacleEdges >> longest & 1) != 0) other = -1;
    if (other >= 0 && (mesh_[other].obstacleEdges >> k & 1) != 0) other = -1;
    if (other < 0) return drop(t, longest);
    if (!mesh_.isUpright(other)) {  // a needle beside a needle: the neighbour goes first
      if (!flip(t, longest, other, k, false)) changed_.insert(changed_.end(), {t, other});
      return true;
    }
    // If the neighbour is a needle too, one of the two new triangles may be turned over, and is repaired next.
    return flip(t, longest, other, k, true);
  }

  // A triangle whose longest edge is a border: its other edges become the border.
  bool drop(Index t, int border) {
    const MeshTriangle triangle = mesh_[t];
    const double drift = mesh_.drift(t) + heightOver(t, border);
    if (!mayDrift(drift)) return false;
    mesh_.kill(t);
    for (const int k : {next(border), previous(border)}) {
      int there = 0;
      const Index other = mesh_.across(triangle.corners[next(k)], triangle.corners[k], there);
      if (other < 0) continue;
      mesh_.setDrift(other, drift);
      if ((triangle.obstacleEdges >> border & 1) != 0) mesh_.markObstacle(other, there);
    }
    return true;
  }

  // Removes a triangle that nothing else repairs, which leaves a slit without width.
  void takeOut(Index t) {
    const MeshTriangle triangle = mesh_[t];
    mesh_.kill(t);
    for (int k = 0; k < 3; ++k) markOpposite(triangle.corners[k], triangle.corners[next(k)]);
  }

  void markOpposite(Index a, Index b) {
    int k = 0;
    if (const Index other = mesh_.across(b, a, k); other >= 0) mesh_.markObstacle(other, k);
  }

  // Hands the corner opposite t's edge k to the neighbour there: the edge is turned. Unless forced, only if both new
  // triangles face up. False, if forced, where that cannot be or drifts too far.
  bool flip(Index t, int k, Index other, int j, bool forced) {
    const MeshTriangle x = mesh_[t], y = mesh_[other];
    const Index a = x.corners[k], b = x.corners[next(k)], c = x.corners[previous(k)], d = y.corners[previous(j)];
    const double drift = std::max(mesh_.drift(t), mesh_.drift(other)) + heightOver(t, k);
    if (c == d || !mayDrift(drift)) return false;  // the same triangle seen from both sides
    if (!forced && (facing(place(c), place(a), place(d)) <= 0 || facing(place(c), place(d), place(b)) <= 0))
      return false;
    const auto flag = [](const MeshTriangle& m, int edge) { return m.obstacleEdges >> edge & 1; };
    MeshTriangle p{{c, a, d}, y.face, 0}, q{{c, d, b}, y.face, 0};
    p.obstacleEdges = static_cast<std::uint8_t>(flag(x, previous(k)) | flag(y, next(j)) << 1);
    q.obstacleEdges = static_cast<std::uint8_t>(flag(y, previous(j)) << 1 | flag(x, next(k)) << 2);
    mesh_.replace(t, p);
    mesh_.setLayer(t, other);
    mesh_.replace(other, q);
    for (const Index made : {t, other}) mesh_.setDrift(made, drift);
    changed_.insert(changed_.end(), {t, other});
    return true;
  }

  bool collapse(Index a, Index b) {
    if (sturdy_[b] != 0 && sturdy_[a] == 0) std::swap(a, b);
    if (sturdy_[a] == sturdy_[b] && b < a) std::swap(a, b);  // b goes to a
    const std::vector<Index> ring = mesh_.around(b);
    double drift = 0;
    for (const Index t : ring)
      if (mesh_.isAlive(t)) drift = std::max(drift, mesh_.drift(t));
    drift += std::sqrt(squaredLength(a, b));
    if (!mayDrift(drift)) return false;
    collapsed_.push_back({b, a});
    for (const Index t : ring) {
      if (!mesh_.isAlive(t)) continue;
      const MeshTriangle& m = mesh_[t];
      if (std::find(m.corners.begin(), m.corners.end(), a) == m.corners.end()) continue;
      mesh_.kill(t);
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
      if (!mesh_.isAlive(t)) continue;
      MeshTriangle moved = mesh_[t];
      std::replace(moved.corners.begin(), moved.corners.end(), b, a);
      mesh_.replace(t, moved);
      mesh_.setDrift(t, drift);
      changed_.push_back(t);
    }
    return true;
  }

  RoundedMesh& rounded_;
  RepairedMesh mesh_;
  const std::vector<char>& sturdy_;
  std::vector<Index> changed_;
  std::vector<std::array<Index, 2>> collapsed_;
};

}  // namespace

std::vector<Vec3> roundVertices(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices,
                                std::vector<char>& exact, RunContext& context) {
  std::vector<Vec3> places(vertices.size());
  exact.assign(vertices.size(), 1);
  parallelRanges(vertices.size(), 256, [&](const auto& range) {
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

RoundingCases repairRounding(RoundedMesh& mesh, const std::vector<char>& sturdy, RunContext& context,
                             const std::vector<Index>& crowded) {
  return RoundingRepair(mesh, sturdy).run(crowded, context);
}

}  // namespace footfall::detail
