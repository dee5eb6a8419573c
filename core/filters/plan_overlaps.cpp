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
// So border triangles are looked up in a tree, and all other pairs are reached across inner sides. On a terrain, nearly
// no triangle needs to be looked up.
#include "core/filters/plan_overlaps.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "core/filters/box_tree.hpp"
#include "core/filters/mesh_geometry.hpp"

namespace footfall {
namespace {

using Pair = std::array<Index, 2>;

Pair ordered(Index s, Index t) { return {std::min(s, t), std::max(s, t)}; }

class OverlapFinder {
 public:
  OverlapFinder(const PlanKernel& kernel, const WalkableMesh& mesh, const MeshTopology& topology, RunContext& context)
      : mesh_(mesh), context_(context), locals_([&] { return Local{MeshGeometry(kernel, mesh.vertices), {}}; }) {
    const auto poll = [this] { context_.checkCancelled(); };
    findInnerSides(topology);
    findAtBorders(poll);
    std::vector<Pair> before, last = collect();
    pairs_ = last;
    while (!last.empty()) {
      const std::vector<Pair> linked = neighborsOf(last);
      if (linked.empty()) break;
      if (before.empty()) std::sort(last.begin(), last.end());
      std::vector<Pair> next = test(linked, last, before);
      std::sort(next.begin(), next.end());
      pairs_.insert(pairs_.end(), next.begin(), next.end());
      before = std::move(last);
      last = std::move(next);
    }
  }

  std::vector<Pair> take(ExactFallbacks& fallbacks) {
    for (const Local& local : locals_) fallbacks += local.geometry.fallbacks;
    return std::move(pairs_);
  }

 private:
  struct Local {
    MeshGeometry geometry;
    std::vector<Pair> found;
  };
  using Tree = BoxTree<2>;

  void findInnerSides(const MeshTopology& topology) {
    across_.assign(mesh_.triangles.size() * 3, -1);
    for (Index e = 0; e < topology.edgeCount(); ++e) {
      const auto sides = topology.sidesOf(e);
      if (sides.size() != 2 || beginOf(mesh_.triangles, sides[0]) == beginOf(mesh_.triangles, sides[1])) continue;
      across_[sides[0]] = sides[1] / 3;
      across_[sides[1]] = sides[0] / 3;
    }
    context_.checkCancelled();
  }

  [[nodiscard]] bool isAtBorder(Index t) const {
    return across_[3 * t] < 0 || across_[3 * t + 1] < 0 || across_[3 * t + 2] < 0;
  }

  [[nodiscard]] Tree::Bounds boundsOf(Index t) const {
    Tree::Bounds bounds;
    for (int k = 0; k < 3; ++k) {
      const MeshVertex& v = mesh_.vertices[mesh_.triangles[t].corners[k]];
      const std::array<double, 2> low{v.x - v.error, v.y - v.error}, high{v.x + v.error, v.y + v.error};
      for (int i = 0; i < 2; ++i) {
        bounds.lower[i] = k == 0 ? low[i] : std::min(bounds.lower[i], low[i]);
        bounds.upper[i] = k == 0 ? high[i] : std::max(bounds.upper[i], high[i]);
      }
    }
    return bounds;
  }

  template <class Poll>
  void findAtBorders(Poll poll) {
    const auto count = static_cast<Index>(mesh_.triangles.size());
    std::vector<Index> queries;
    for (Index t = 0; t < count; ++t)
      if (isAtBorder(t)) queries.push_back(t);
    Tree tree;
    tree.build(count, [this](Index t) { return boundsOf(t); }, poll);
    tbb::parallel_for(std::size_t{0}, (queries.size() + kPerTask - 1) / kPerTask, [&](std::size_t task) {
      Local& local = locals_.local();
      for (std::size_t i = task * kPerTask; i < std::min((task + 1) * kPerTask, queries.size()); ++i) {
        context_.checkCancelled();
        const Index t = queries[i];
        tree.visitOverlapping(boundsOf(t), [&](Index o) {
          if (o == t || (o > t && isAtBorder(o)) || shareEdge(t, o)) return;
          if (local.geometry.overlap(mesh_.triangles[t], mesh_.triangles[o])) local.found.push_back(ordered(t, o));
        });
      }
    });
  }

  /// Triangles on either side of an edge do not overlap; a test by numbers saves the exact one.
  [[nodiscard]] bool shareEdge(Index s, Index t) const {
    return across_[3 * s] == t || across_[3 * s + 1] == t || across_[3 * s + 2] == t;
  }

  // What the threads found, in no particular order.
  std::vector<Pair> collect() {
    std::vector<Pair> result;
    for (Local& local : locals_) {
      result.insert(result.end(), local.found.begin(), local.found.end());
      local.found.clear();
    }
    return result;
  }

  // Linked pairs without border triangles, sorted.
  std::vector<Pair> neighborsOf(const std::vector<Pair>& pairs) const {
    std::vector<Pair> result;
    const auto add = [&](Index s, Index t) {
      if (s >= 0 && t >= 0 && s != t && !isAtBorder(s) && !isAtBorder(t)) result.push_back(ordered(s, t));
    };
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (p % 4096 == 0) context_.checkCancelled();
      const auto [s, t] = pairs[p];
      for (int i = 0; i < 3; ++i) {
        add(across_[3 * s + i], t);
        add(s, across_[3 * t + i]);
        for (int j = 0; j < 3; ++j) add(across_[3 * s + i], across_[3 * t + j]);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Those pairs that overlap. A pair that is linked with the last ones and was found before is among the last ones or
  // those before them.
  std::vector<Pair> test(const std::vector<Pair>& pairs, const std::vector<Pair>& last,
                         const std::vector<Pair>& before) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs.size(), kPerTask), [&](const auto& range) {
      context_.checkCancelled();
      Local& local = locals_.local();
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        const auto [s, t] = pairs[i];
        if (shareEdge(s, t) || std::binary_search(last.begin(), last.end(), pairs[i]) ||
            std::binary_search(before.begin(), before.end(), pairs[i]))
          continue;
        if (local.geometry.overlap(mesh_.triangles[s], mesh_.triangles[t])) local.found.push_back(pairs[i]);
      }
    });
    return collect();
  }

  static constexpr std::size_t kPerTask = 256;

  const WalkableMesh& mesh_;
  RunContext& context_;
  tbb::enumerable_thread_specific<Local> locals_;
  std::vector<Index> across_;  ///< for each side the triangle beyond it when it is inner, else -1
  std::vector<Pair> pairs_;
};

}  // namespace

std::vector<Pair> findPlanOverlaps(const PlanKernel& kernel, const WalkableMesh& mesh, const MeshTopology& topology,
                                   RunContext& context, ExactFallbacks& fallbacks) {
  return OverlapFinder(kernel, mesh, topology, context).take(fallbacks);
}

}  // namespace footfall
