// SPDX-License-Identifier: GPL-3.0-or-later
//
// Call a side inner when exactly one other triangle has its edge, on the other side of it; a triangle with another side
// is a border triangle. All triangles face up. Take all overlapping pairs, and link (s, t) with (s', t), (s, t') and
// (s', t') where s' and t' are neighbours across inner sides. Every set of linked pairs has a pair with a border
// triangle in it:
//
// Suppose not, and glue the intersections of the pairs of such a set along their edges. A point on the edge of the
// intersection of s and t, corners aside, lies on a side of s, and within t or on a side of t as well (or the other way
// round). That side is inner, so beyond it lies s', which overlaps t there; where sides of both meet, s' and t' overlap
// beyond them. That pair is linked, so the glued surface goes on. Its image in the plan is then compact, not empty, and
// has a finite number of border points at most; there is no such set.
//
// So border triangles are looked up in a tree first. Of the others, only those need to be looked up that are in a pair
// or across a side from one that is: from a border triangle's pair to any other one that it is linked with, each step
// is found so. On a terrain, nearly no triangle needs to be looked up.
#include "core/filters/layers/plan_overlaps.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {
namespace {

using Pair = std::array<Index, 2>;

class OverlapFinder {
 public:
  OverlapFinder(const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context)
      : mesh_(mesh), context_(context), locals_([&kernel, &mesh] {
          return Local{MeshGeometry(kernel, mesh.vertices), {}};
        }) {}

  /// False when there are more pairs than `most`.
  bool findAll(const Adjacency& topology, std::size_t most) {
    most_ = most;
    findInnerSides(topology);
    findPlanTriangles();
    std::vector<Index> all(mesh_.triangles.size());
    std::iota(all.begin(), all.end(), Index{0});
    round_.assign(all.size(), kNever);
    findAmong(all);
    return !tooMany();
  }

  // A region is a mesh of its own: what lies beyond its sides in other regions does not count.
  void findWithin(const Adjacency& topology, const std::vector<Index>& region, Index regionCount) {
    findInnerSides(topology);
    findPlanTriangles();
    const auto count = static_cast<Index>(mesh_.triangles.size());
    for (Index side = 0; side < 3 * count; ++side)
      if (across_[side] >= 0 && region[across_[side]] != region[side / 3]) across_[side] = -1;
    std::vector<std::vector<Index>> members(regionCount);
    for (Index t = 0; t < count; ++t) members[region[t]].push_back(t);
    round_.assign(count, kNever);
    for (const std::vector<Index>& triangles : members) {
      context_.checkCancelled();
      if (triangles.size() > 1) findAmong(triangles);
    }
  }

  // What is known of two triangles that are still there holds; others are compared with all.
  void update(const std::vector<Pair>& before, const MeshRelation& relation) {
    const TriangleCorners corners(mesh_.triangles);
    across_.assign(mesh_.triangles.size() * 3, -1);
    findPlanTriangles();
    std::vector<Index> now(relation.triangleCountBefore, -1), kept, changed;
    for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t) {
      const Index then = relation.triangleBefore[t];
      if (then >= 0) now[then] = t;
      (then >= 0 ? kept : changed).push_back(t);
    }
    for (const auto& [s, t] : before)
      if (now[s] >= 0 && now[t] >= 0) pairs_.push_back({now[s], now[t]});
    context_.checkCancelled();
    const Tree tree = treeOf(changed);
    lookUpBorders(tree);
    lookUp(kept.size(), [&](Local& local, std::size_t i) {
      tree.visitOverlapping(boundsOf(kept[i]), [&](Index o) { test(local, kept[i], o); });
    });
  }

  std::vector<Pair> take(ExactFallbacks& fallbacks) {
    for (const Local& local : locals_) fallbacks += local.geometry.fallbacks;
    return std::move(pairs_);
  }

 private:
  // All pairs among these triangles (ascending), of which every inner side leads to another one of them.
  void findAmong(const std::vector<Index>& triangles) {
    std::vector<Index> border, inner;
    for (const Index t : triangles) (isAtBorder(t) ? border : inner).push_back(t);
    const Tree borders = treeOf(border);
    inner_ = treeOf(inner);
    std::size_t known = pairs_.size();
    lookUpBorders(borders);
    std::vector<Index> queries;
    for (Index round = 0; !inner.empty() && !tooMany(); ++round) {
      for (; known < pairs_.size(); ++known) {
        if (known % 4096 == 0) context_.checkCancelled();
        for (const Index t : pairs_[known]) {
          addQuery(t, round, queries);
          for (int k = 0; k < 3; ++k)
            if (across_[3 * t + k] >= 0) addQuery(across_[3 * t + k], round, queries);
        }
      }
      if (queries.empty()) break;
      lookUpInner(queries, round);
      queries.clear();
    }
  }

  struct Local {
    MeshGeometry geometry;
    std::vector<Pair> found;
  };
  using Tree = BoxTree<2>;

  void findInnerSides(const Adjacency& topology) {
    const TriangleCorners corners(mesh_.triangles);
    across_.assign(mesh_.triangles.size() * 3, -1);
    for (Index e = 0; e < topology.edgeCount(); ++e) {
      const auto sides = topology.sidesOf(e);
      if (sides.size() != 2 || corners.beginOf(sides[0]) == corners.beginOf(sides[1])) continue;
      across_[sides[0]] = sides[1] / 3;
      across_[sides[1]] = sides[0] / 3;
    }
    context_.checkCancelled();
  }

  [[nodiscard]] bool isAtBorder(Index t) const {
    return across_[3 * t] < 0 || across_[3 * t + 1] < 0 || across_[3 * t + 2] < 0;
  }

  void findPlanTriangles() {
    const auto count = static_cast<Index>(mesh_.triangles.size());
    plan_.resize(count);
    tbb::parallel_for(tbb::blocked_range<Index>(0, count, kTrianglesPerTask), [&](const auto& range) {
      context_.checkCancelled();
      for (Index t = range.begin(); t != range.end(); ++t)
        plan_[t] = planTriangleOf(mesh_.vertices, mesh_.triangles[t]);
    });
  }

  [[nodiscard]] Tree::Bounds boundsOf(Index t) const {
    const PlanTriangle& p = plan_[t];
    return {{std::min({p.x[0], p.x[1], p.x[2]}) - p.error, std::min({p.y[0], p.y[1], p.y[2]}) - p.error},
            {std::max({p.x[0], p.x[1], p.x[2]}) + p.error, std::max({p.y[0], p.y[1], p.y[2]}) + p.error}};
  }

  [[nodiscard]] Tree treeOf(const std::vector<Index>& triangles) const {
    Tree tree;
    tree.build(
        triangles, [this](Index t) { return boundsOf(t); }, context_);
    return tree;
  }

  void addQuery(Index t, Index round, std::vector<Index>& queries) {
    if (round_[t] != kNever || isAtBorder(t)) return;
    round_[t] = round;
    queries.push_back(t);
  }

  // Runs look(local, i) for all i below count on all threads, and takes what the threads found.
  template <class Look>
  void lookUp(std::size_t count, Look look) {
    tbb::parallel_for(std::size_t{0}, (count + kPerTask - 1) / kPerTask, [&](std::size_t task) {
      Local& local = locals_.local();
      for (std::size_t i = task * kPerTask; i < std::min((task + 1) * kPerTask, count) && !tooMany(); ++i) {
        context_.checkCancelled();
        const std::size_t before = local.found.size();
        look(local, i);
        foundCount_.fetch_add(local.found.size() - before, std::memory_order_relaxed);
      }
    });
    for (Local& local : locals_) {
      pairs_.insert(pairs_.end(), local.found.begin(), local.found.end());
      local.found.clear();
    }
  }

  [[nodiscard]] bool tooMany() const { return foundCount_.load(std::memory_order_relaxed) > most_; }

  void test(Local& local, Index t, Index o) const {
    if (shareEdge(t, o)) return;
    context_.checkCancelled();
    if (local.geometry.overlap(plan_[t], plan_[o])) local.found.push_back({t, o});
  }

  void lookUpBorders(const Tree& borders) {
    lookUp(static_cast<std::size_t>(borders.size()), [&](Local& local, std::size_t place) {
      const Index t = borders.idAt(static_cast<Index>(place));
      const Tree::Bounds bounds = boundsOf(t);
      borders.visitOverlapping(
          bounds, [&](Index o) { test(local, t, o); }, static_cast<Index>(place) + 1);
      inner_.visitOverlapping(bounds, [&](Index o) { test(local, t, o); });
    });
  }

  // Each pair is found when its first triangle is looked up, or the larger one when both are in the same round.
  void lookUpInner(const std::vector<Index>& queries, Index round) {
    lookUp(queries.size(), [&](Local& local, std::size_t i) {
      const Index t = queries[i];
      inner_.visitOverlapping(boundsOf(t), [&](Index o) {
        if (round_[o] > round || (round_[o] == round && o < t)) test(local, t, o);
      });
    });
  }

  /// Triangles on either side of an edge do not overlap; a test by numbers saves the exact one.
  [[nodiscard]] bool shareEdge(Index s, Index t) const {
    return across_[3 * s] == t || across_[3 * s + 1] == t || across_[3 * s + 2] == t;
  }

  static constexpr std::size_t kPerTask = 256;
  static constexpr Index kTrianglesPerTask = 4096;
  static constexpr Index kNever = std::numeric_limits<Index>::max();

  const WalkableMesh& mesh_;
  RunContext& context_;
  tbb::enumerable_thread_specific<Local> locals_;
  std::vector<Index> across_;  ///< for each side the triangle beyond it when it is inner, else -1
  std::vector<PlanTriangle> plan_;
  Tree inner_;
  std::vector<Index> round_;  ///< in which each inner triangle was looked up
  std::vector<Pair> pairs_;
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::atomic<std::size_t> foundCount_{0};
};

}  // namespace

std::optional<std::vector<Pair>> findPlanOverlaps(const PlanKernel& kernel, const WalkableMesh& mesh,
                                                  const Adjacency& topology, std::size_t most, RunContext& context,
                                                  ExactFallbacks& fallbacks) {
  OverlapFinder finder(kernel, mesh, context);
  const bool isComplete = finder.findAll(topology, most);
  if (!isComplete) return std::nullopt;  // where it stopped is a matter of threads: not even fall-backs are told
  return finder.take(fallbacks);
}

std::vector<Pair> findPlanOverlapsWithin(const std::vector<Index>& region, Index regionCount, const PlanKernel& kernel,
                                         const WalkableMesh& mesh, const Adjacency& topology, RunContext& context,
                                         ExactFallbacks& fallbacks) {
  OverlapFinder finder(kernel, mesh, context);
  finder.findWithin(topology, region, regionCount);
  return finder.take(fallbacks);
}

std::vector<Pair> updatePlanOverlaps(const std::vector<Pair>& before, const MeshRelation& relation,
                                     const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context,
                                     ExactFallbacks& fallbacks) {
  OverlapFinder finder(kernel, mesh, context);
  finder.update(before, relation);
  return finder.take(fallbacks);
}

}  // namespace footfall::detail
