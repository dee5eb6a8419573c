// SPDX-License-Identifier: GPL-3.0-or-later
//
// Call a side inner when exactly one other triangle has its edge, on the other side of it; a triangle with another side
// is a border triangle. All triangles face up. Take all overlapping pairs, and link (s, t) with (s', t), (s, t') and
// (s', t') where s' and t' are neighbours across inner sides, in the third case ones that lie on one line. Every set of
// linked pairs has a pair of which one triangle has a border side that lies, along a piece of it, within the other one
// or on its border:
//
// Glue the intersections of the pairs of such a set along their edges. A point on the edge of the intersection of s and
// t, corners aside, lies on a side of s, and within t or on a side of t as well (or the other way round). Where all
// those sides are inner, s' beyond the one overlaps t there, or s' and t' beyond both overlap each other. That pair is
// linked, so the glued surface goes on. If that were so everywhere, its image in the plan would be compact, not empty,
// and would have a finite number of border points at most; there is no such set. So the surface ends along a border
// side.
//
// So border triangles are looked up in a tree first. Of the others, only those need to be looked up that are in a pair
// or across a side from one that is: from such a pair to any other one that it is linked with, each step is found so.
// On a terrain, nearly no triangle needs to be looked up.
//
// Borders with thousands of vertices have needles, the boxes of which hold most of the others. Border sides are short
// where there are many; so where boxes touch many more than overlap, the sides that each triangle touches are looked up
// (border_sides.hpp), and the pairs with their triangles lead to all others over the links above. Each pair costs a few
// tests, however many boxes touch each other. There, too, sheets that cover no place twice are found first, by their
// outlines (cover_sweep.hpp): no pair of their own triangles is tested.
#include "core/filters/layers/plan_overlaps.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/base/main_direction.hpp"
#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "core/base/unfilled_array.hpp"
#include "core/filters/layers/border_sides.hpp"
#include "core/filters/layers/double_cover.hpp"
#include "core/filters/layers/pair_set.hpp"
#include "core/filters/layers/plan_triangles.hpp"
#include "core/filters/layers/triangle_sides.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {
namespace {

using Pair = std::array<Index, 2>;

class OverlapFinder {
 public:
  OverlapFinder(const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context)
      : mesh_(mesh),
        context_(context),
        kernel_(kernel),
        locals_([&kernel, &mesh] {
          return Local{MeshGeometry(kernel, mesh.vertices), {}, {}, {}};
        }),
        places_(mesh.vertices.size()) {
    parallelRanges(places_.size(), kVerticesPerTask, [&](const auto& range) {
      context_.checkCancelled();
      for (std::size_t v = range.begin(); v != range.end(); ++v) places_.fill(v, planPlaceOf(mesh_.vertices[v]));
    });
    turn_ = findTurn();
  }

  /// False when there are more pairs than `most`.
  bool findAll(const Adjacency& topology, std::size_t most) {
    most_ = most;
    across_ = findTrianglesAcross(mesh_, topology, context_);
    std::vector<Index> all(mesh_.triangles.size());
    std::iota(all.begin(), all.end(), Index{0});
    round_.assign(all.size(), kNever);
    isSpread_.assign(all.size(), 0);
    findAmong(std::move(all));
    return !tooMany();
  }

  // Results for two triangles that still exist are kept; other triangles are compared with all.
  void update(const std::vector<Pair>& before, const MeshRelation& relation) {
    const TriangleCorners corners(mesh_.triangles);
    across_.assign(mesh_.triangles.size() * 3, -1);
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
    forEach(kept.size(), [&](Local& local, std::size_t i) {
      const PlanTriangle plan = planOf(kept[i]);
      tree.visitOverlapping(boundsOf(plan), [&](Index o) { test(local, kept[i], plan, o); });
    });
  }

  /// The number of pairs that were tested, and of exact decisions about outlines.
  [[nodiscard]] std::size_t tested() const {
    std::size_t count = decisions_;
    for (const Local& local : locals_) count += local.tested;
    return count;
  }

  std::vector<Pair> take(ExactFallbacks& fallbacks) {
    fallbacks += sheetFallbacks_;
    for (const Local& local : locals_) fallbacks += local.geometry.fallbacks;
    return std::move(pairs_);
  }

 private:
  using Tree = BoxTree<2>;
  struct Local {
    MeshGeometry geometry;
    std::vector<Pair> found;
    std::vector<Index> hits;
    std::vector<Tree::Bounds> bounds;  ///< of the triangles that are looked up together
    std::size_t tested = 0;
  };

  // All pairs among these triangles (ascending), of which every inner side leads to another one of them.
  void findAmong(std::vector<Index> triangles) {
    if (countNeedles(triangles) >= kFewNeedles && boxesTouchTooManyOthers(triangles)) {
      findAmongNeedles(std::move(triangles));
      return;
    }
    std::vector<Index> border, other;
    for (const Index t : triangles) (isAtBorder(t) ? border : other).push_back(t);
    triangles = {};
    for (const Index t : border) round_[t] = 0;
    others_ = treeOf(other);
    other = {};
    const std::size_t known = pairs_.size();
    lookUpBorders(treeOf(border));
    spread(known, 1);
  }

  void findAmongNeedles(std::vector<Index> triangles) {
    sheet_ = findFlatSheets(across_, kernel_, mesh_, context_, sheetFallbacks_, &decisions_);
    dropLonelySheets(triangles);
    gatherSides(triangles);
    timesFound_ = kMostTimesFound;
    // In batches, so that of thousands of floors above each other few are before there are too many pairs.
    PairSet known;
    std::size_t batch = kFirstBatch;
    for (std::size_t begin = 0; begin < triangles.size() && !tooMany(); begin += batch, batch *= 2) {
      const std::size_t first = pairs_.size(), last = std::min(begin + batch, triangles.size());
      forEach(last - begin, [&](Local& local, std::size_t i) { findBordersNear(local, triangles[begin + i]); });
      follow(first, known);
    }
  }

  // Finds all pairs that those from `first` on are linked with; `known` has the ones before.
  void follow(std::size_t first, PairSet& known) {
    while (!tooMany()) {
      keepNew(first, known);
      const std::size_t end = pairs_.size();
      if (first == end) return;
      forEach(end - first, [&](Local& local, std::size_t i) { testLinked(local, pairs_[first + i], known); });
      first = end;
    }
  }

  // Drops the known ones of the pairs from `first` on.
  void keepNew(std::size_t first, PairSet& known) {
    std::size_t kept = first;
    for (std::size_t i = first; i < pairs_.size(); ++i) {
      if (i % kPolled == 0) context_.checkCancelled();
      if (const Pair pair = pairs_[i]; known.insert(pair)) pairs_[kept++] = pair;
    }
    pairs_.resize(kept);
    foundCount_ = kept > most_ ? std::numeric_limits<std::size_t>::max() : kept;
  }

  void testLinked(Local& local, const Pair& pair, const PairSet& known) const {
    const TriangleAndAcross first = withAcross(pair[0]), second = withAcross(pair[1]);
    std::array<std::array<std::uint8_t, 2>, 16> linked{};
    std::size_t count = 0;
    for (std::uint8_t i = 0; i < first.size(); ++i) {
      for (std::uint8_t j = 0; j < second.size(); ++j) {
        const BoxedTriangle &s = first[i], &t = second[j];
        if (s.triangle < 0 || t.triangle < 0 || t.triangle == s.triangle || s.isApartFrom(t)) continue;
        if (i > 0 && j > 0 && !mayLieOnOneLine(first[0].plan, i - 1, second[0].plan, j - 1, kernel_.sign().slack))
          continue;
        known.prefetch(orderedPair(s.triangle, t.triangle));
        linked[count++] = {i, j};
      }
    }
    for (std::size_t n = 0; n < count; ++n) {
      const BoxedTriangle &s = first[linked[n][0]], &t = second[linked[n][1]];
      const Pair other = orderedPair(s.triangle, t.triangle);
      if (!known.contains(other) && overlaps(local, s.triangle, s.plan, t.triangle)) local.found.push_back(other);
    }
  }

  [[nodiscard]] TriangleAndAcross withAcross(Index t) const {
    TriangleAndAcross all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Index triangle = i == 0 ? t : across_[3 * t + i - 1];
      if (triangle < 0) continue;
      const PlanTriangle plan = planOf(triangle);
      all[i] = {triangle, plan, planBoundsOf(plan)};
    }
    return all;
  }

  [[nodiscard]] static Pair orderedPair(Index s, Index t) { return {std::max(s, t), std::min(s, t)}; }

  // Looks up what the pairs from `known` on are linked with, beginning with a round that has not been; returns the next
  // one.
  Index spread(std::size_t known, Index round) {
    std::vector<Index> queries;
    for (; known < pairs_.size() && !tooMany(); ++round) {
      for (; known < pairs_.size(); ++known) {
        if (known % 4096 == 0) context_.checkCancelled();
        for (const Index t : pairs_[known]) {
          if (std::exchange(isSpread_[t], 1) != 0) continue;
          addQuery(t, round, queries);
          for (int k = 0; k < 3; ++k)
            if (across_[3 * t + k] >= 0) addQuery(across_[3 * t + k], round, queries);
        }
      }
      lookUp(queries, round);
      queries.clear();
    }
    return round;
  }

  [[nodiscard]] bool isAtBorder(Index t) const {
    return across_[3 * t] < 0 || across_[3 * t + 1] < 0 || across_[3 * t + 2] < 0;
  }

  [[nodiscard]] PlanTriangle planOf(Index t) const {
    return planTriangleOf(mesh_.triangles[t], [this](Index v) -> const PlanPlace& { return places_[v]; });
  }

  /// The direction that most edges follow, in a sample; nothing where that is an axis.
  [[nodiscard]] std::optional<std::array<double, 2>> findTurn() const {
    constexpr std::size_t kTriangles = MainDirection::kEnough / 3;
    const std::size_t count = mesh_.triangles.size(), step = std::max<std::size_t>(count / kTriangles, 1);
    MainDirection direction;
    for (std::size_t t = 0; t < count; t += step) {
      const PlanTriangle plan = planOf(static_cast<Index>(t));
      for (std::size_t a = 0; a < 3; ++a)
        direction.add(plan.x[(a + 1) % 3] - plan.x[a], plan.y[(a + 1) % 3] - plan.y[a]);
    }
    return direction.find();
  }

  /// A box of a triangle, along the main direction of the level: those of triangles that overlap touch each other.
  [[nodiscard]] Tree::Bounds boundsOf(const PlanTriangle& plan) const {
    if (!turn_) return planBoundsOf(plan);
    const auto& [x, y] = *turn_;
    PlanTriangle turned = plan;
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      turned.x[k] = x * plan.x[k] + y * plan.y[k];
      turned.y[k] = x * plan.y[k] - y * plan.x[k];
      size = std::max({size, std::fabs(plan.x[k]), std::fabs(plan.y[k])});
    }
    turned.error = 2 * plan.error + size * kRoundingOfTurn;
    return planBoundsOf(turned);
  }
  [[nodiscard]] Tree::Bounds boundsOf(Index t) const { return boundsOf(planOf(t)); }

  [[nodiscard]] Tree treeOf(const std::vector<Index>& triangles) const {
    Tree tree;
    tree.build(
        triangles, [this](Index t) { return boundsOf(t); }, context_);
    return tree;
  }

  void addQuery(Index t, Index round, std::vector<Index>& queries) {
    if (round_[t] != kNever) return;
    round_[t] = round;
    queries.push_back(t);
  }

  // Runs look(local, i) for all i below count on all threads, and takes what the threads found.
  template <class Look>
  void forEach(std::size_t count, Look look) {
    // Some need much longer than others: tasks stay small.
    forRanges((count + kPerTask - 1) / kPerTask, 1, [&](std::size_t first, std::size_t last) {
      Local& local = locals_.local();
      for (std::size_t i = first * kPerTask; i < std::min(last * kPerTask, count) && !tooMany(); ++i) {
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

  [[nodiscard]] bool tooMany() const { return foundCount_.load(std::memory_order_relaxed) / timesFound_ > most_; }

  void test(Local& local, Index t, const PlanTriangle& plan, Index o) const {
    if (overlaps(local, t, plan, o)) local.found.push_back({t, o});
  }

  [[nodiscard]] bool overlaps(Local& local, Index t, const PlanTriangle& plan, Index o) const {
    if (shareEdge(t, o) || areOnOneSheet(t, o)) return false;
    context_.checkCancelled();
    ++local.tested;
    return local.geometry.overlap(plan, planOf(o));
  }

  // Finds the pairs of a triangle and one that has a border side near it.
  void findBordersNear(Local& local, Index t) const {
    const PlanTriangle plan = planOf(t);
    local.hits.clear();
    sides_.visitNear(plan, planBoundsOf(plan), [&](Index o) {
      if (o != t && !areOnOneSheet(t, o)) local.hits.push_back(o);
    });
    sortOnce(local.hits);
    for (const Index o : local.hits)
      if (overlaps(local, t, plan, o)) local.found.push_back(orderedPair(t, o));
  }

  /// True where the box of a triangle is far larger than the triangle.
  [[nodiscard]] bool isNeedle(Index t) const {
    const PlanTriangle p = planOf(t);
    const Tree::Bounds b = planBoundsOf(p);
    const double area = std::fabs((p.x[1] - p.x[0]) * (p.y[2] - p.y[0]) - (p.x[2] - p.x[0]) * (p.y[1] - p.y[0]));
    return (b.upper[0] - b.lower[0]) * (b.upper[1] - b.lower[1]) > kBoxOfNeedle * area;
  }

  [[nodiscard]] std::size_t countNeedles(const std::vector<Index>& triangles) const {
    return std::count_if(triangles.begin(), triangles.end(), [&](Index t) { return isNeedle(t); });
  }

  /// Whether most boxes that touch a triangle's are of triangles that it does not overlap, in a sample: then looking up
  /// boxes takes longer than following pairs.
  [[nodiscard]] bool boxesTouchTooManyOthers(const std::vector<Index>& triangles) {
    const Tree tree = treeOf(triangles);
    const std::size_t step = triangles.size() / kSampled + 1;
    std::size_t sampled = 0, touching = 0, overlapping = 0;
    for (std::size_t i = 0; i < triangles.size() && touching < kMostTouching; i += step, ++sampled) {
      const Index t = triangles[i];
      const PlanTriangle plan = planOf(t);
      tree.visitOverlapping(boundsOf(plan), [&](Index o) {
        if (o == t || ++touching > kMostTouching) return;
        if (overlaps(locals_.local(), t, plan, o)) ++overlapping;
      });
    }
    return touching > kFewTouching * sampled && touching > kTouchingPerPair * overlapping;
  }

  /// Takes away the triangles of flat sheets whose boxes touch that of no other sheet: they overlap nothing.
  void dropLonelySheets(std::vector<Index>& triangles) const {
    Index sheets = 0;
    for (const Index t : triangles) sheets = std::max(sheets, sheet_[t] + 1);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::vector<Tree::Bounds> boxes(sheets, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}});
    for (const Index t : triangles) {
      const Tree::Bounds own = boundsOf(t);
      if (sheet_[t] < 0) {
        boxes.push_back(own);
        continue;
      }
      Tree::Bounds& all = boxes[sheet_[t]];
      for (std::size_t k = 0; k < 2; ++k) {
        all.lower[k] = std::min(all.lower[k], own.lower[k]);
        all.upper[k] = std::max(all.upper[k], own.upper[k]);
      }
    }
    std::vector<Index> all(boxes.size());
    std::iota(all.begin(), all.end(), Index{0});
    Tree tree;
    tree.build(
        all, [&](Index box) { return boxes[box]; }, context_);
    std::vector<char> isLonely(sheets, 1);
    for (Index sheet = 0; sheet < sheets; ++sheet)
      tree.visitOverlapping(boxes[sheet], [&](Index box) {
        if (box != sheet) isLonely[sheet] = 0;
      });
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                   [&](Index t) { return sheet_[t] >= 0 && isLonely[sheet_[t]] != 0; }),
                    triangles.end());
  }

  void gatherSides(const std::vector<Index>& triangles) {
    std::vector<BorderSides::Side> sides;
    for (const Index t : triangles) {
      const PlanTriangle p = planOf(t);
      for (std::size_t a = 0; a < 3; ++a)
        if (const std::size_t b = (a + 1) % 3; across_[3 * t + a] < 0)
          sides.push_back({t, {p.x[a], p.y[a]}, {p.x[b], p.y[b]}, p.error});
    }
    sides_.build(sides, context_);
  }

  void lookUpBorders(const Tree& borders) {
    const Index count = borders.size();
    forEach(static_cast<std::size_t>((count + Tree::kRow - 1) / Tree::kRow), [&](Local& local, std::size_t row) {
      const Index first = static_cast<Index>(row) * Tree::kRow, last = std::min(first + Tree::kRow, count);
      std::array<PlanTriangle, Tree::kRow> plans;
      local.bounds.clear();
      for (Index place = first; place < last; ++place) {
        plans[place - first] = planOf(borders.idAt(place));
        local.bounds.push_back(boundsOf(plans[place - first]));
      }
      borders.visitOverlapping(first, local.bounds, [&](Index place, Index o) {
        test(local, borders.idAt(place), plans[place - first], o);
      });
      for (Index place = first; place < last; ++place)
        others_.visitOverlapping(local.bounds[place - first],
                                 [&](Index o) { test(local, borders.idAt(place), plans[place - first], o); });
    });
  }

  // Each pair is found when its first triangle is looked up, or the larger one when both are in the same round.
  void lookUp(const std::vector<Index>& queries, Index round) {
    forEach(queries.size(), [&](Local& local, std::size_t i) {
      const Index t = queries[i];
      const PlanTriangle plan = planOf(t);
      others_.visitOverlapping(boundsOf(plan), [&](Index o) {
        if (round_[o] > round || (round_[o] == round && o < t)) test(local, t, plan, o);
      });
    });
  }

  /// Triangles on either side of an edge do not overlap; a test by numbers saves the exact one.
  [[nodiscard]] bool shareEdge(Index s, Index t) const {
    return across_[3 * s] == t || across_[3 * s + 1] == t || across_[3 * s + 2] == t;
  }

  /// Triangles of a sheet that covers no place twice do not overlap.
  [[nodiscard]] bool areOnOneSheet(Index s, Index t) const {
    return !sheet_.empty() && sheet_[s] >= 0 && sheet_[s] == sheet_[t];
  }

  static constexpr std::size_t kPerTask = 32, kFirstBatch = 256, kVerticesPerTask = 2048, kPolled = 4096;
  static constexpr double kBoxOfNeedle = 64;
  static constexpr double kRoundingOfTurn = 0x1p-50;  ///< two products with parts of a unit vector, and their sum
  /// A pair is linked with 15 others, or found once from either triangle.
  static constexpr std::size_t kMostTimesFound = 16;
  static constexpr std::size_t kSampled = 128, kMostTouching = std::size_t{1} << 15;
  static constexpr std::size_t kFewTouching = 32, kTouchingPerPair = 10;  ///< measured: where either way takes as long
  static constexpr std::size_t kFewNeedles = 1024;
  static constexpr Index kNever = std::numeric_limits<Index>::max();

  const WalkableMesh& mesh_;
  RunContext& context_;
  const PlanKernel& kernel_;
  PerThread<Local> locals_;
  std::optional<std::array<double, 2>> turn_;  ///< of the boxes that boundsOf() returns
  UnfilledArray<PlanPlace> places_;  ///< of the vertices: a third of what they take, and looked up all the time
  std::vector<Index> across_;        ///< for each side the triangle beyond it when it is inner, else -1
  std::vector<Index> sheet_;         ///< findFlatSheets(); empty where there are few needles
  std::size_t decisions_ = 0;
  ExactFallbacks sheetFallbacks_;
  Tree others_;                 ///< those that are not looked up at first
  BorderSides sides_;           ///< border sides; empty where there are few needles
  std::vector<Index> round_;    ///< in which each triangle was looked up
  std::vector<char> isSpread_;  ///< whether spread() met it
  std::vector<Pair> pairs_;
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::size_t timesFound_ = 1;  ///< the number of times that a pair may be found before keepNew()
  std::atomic<std::size_t> foundCount_{0};
};

}  // namespace

std::optional<std::vector<Pair>> findPlanOverlaps(const PlanKernel& kernel, const WalkableMesh& mesh,
                                                  const Adjacency& topology, std::size_t most, RunContext& context,
                                                  ExactFallbacks& fallbacks, std::size_t* tested) {
  OverlapFinder finder(kernel, mesh, context);
  const bool isComplete = finder.findAll(topology, most);
  if (tested != nullptr) *tested = finder.tested();
  // the place where it stopped depends on threads, so not even fall-backs are reported
  if (!isComplete) return std::nullopt;
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
