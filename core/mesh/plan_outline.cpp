// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/plan_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/base/vector.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/mesh/adjacency.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 1 << 14;
constexpr int kRounding = -40;  // A power of two, relative to the extent: smaller distances may be due to rounding
                                // alone.
constexpr std::size_t kNoSide = static_cast<std::size_t>(-1);

/// A side of a triangle, with the triangle on its left.
struct Side {
  std::uint32_t from = 0, to = 0;            ///< vertices of the mesh
  std::uint32_t fromPlace = 0, toPlace = 0;  ///< The two places decide which sides are one edge.
  std::uint32_t triangle = 0;                ///< its place in the list that is outlined
};

auto edgeOf(const Side& side) { return std::minmax(side.fromPlace, side.toPlace); }

/// Sides of one edge follow each other; among them those with the same vertices do.
bool comesBefore(const Side& a, const Side& b) {
  return std::tuple(edgeOf(a), std::minmax(a.from, a.to), a.triangle) <
         std::tuple(edgeOf(b), std::minmax(b.from, b.to), b.triangle);
}

/// The first vertex at the same place in the plan, of each vertex.
std::vector<std::uint32_t> placesOf(const NavigationMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size()), places(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&mesh](std::uint32_t v) { return std::tuple(mesh.vertices[v].x, mesh.vertices[v].y, v); };
  std::sort(order.begin(), order.end(), [&key](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec3& p = mesh.vertices[order[i]];
    const Vec3& q = mesh.vertices[first];
    if (i == 0 || p.x != q.x || p.y != q.y) first = order[i];
    places[order[i]] = first;
  }
  return places;
}

class Outliner {
 public:
  Outliner(const NavigationMesh& mesh, std::span<const std::uint32_t> triangles, EdgeRule rule, Poll poll,
           std::span<const std::uint32_t> groups)
      : mesh_(mesh), triangles_(triangles), groups_(groups), rule_(rule), poll_(poll), parts_(triangles.size()) {
    std::vector<std::uint32_t> places;
    if (rule == EdgeRule::SamePlace) places = placesOf(mesh);
    const auto placeOf = [&places](std::uint32_t v) { return places.empty() ? v : places[v]; };
    sides_.reserve(3 * triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[triangles[i]];
      for (int k = 0; k < 3; ++k)
        sides_.push_back({t[k], t[next(k)], placeOf(t[k]), placeOf(t[next(k)]), static_cast<std::uint32_t>(i)});
    }
    poll_();
    std::sort(sides_.begin(), sides_.end(), comesBefore);
    for (const StepLink& link : mesh.links) linked_.insert(linked_.end(), {link.from, link.to});
    std::sort(linked_.begin(), linked_.end());
  }

  PlanOutline outline() {
    for (const Vec3& p : mesh_.vertices) extent_ = std::max({extent_, std::abs(p.x), std::abs(p.y)});
    pairSides();
    if (rule_ == EdgeRule::SamePlace && splitBorder()) {
      isCut_ = true;
      sides_ = std::exchange(border_, {});
      std::sort(sides_.begin(), sides_.end(), comesBefore);
      pairSides();
    }
    Index count = 0;
    const std::vector<Index> partOf = parts_.numbers(count);
    result_.parts.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < triangles_.size(); ++i) result_.parts[partOf[i]].triangles.push_back(triangles_[i]);
    traceRings(partOf);
    // Slivers alone give a part no outline.
    std::erase_if(result_.parts, [](const PlanPart& part) { return part.outer.empty(); });
    return std::move(result_);
  }

 private:
  /// Sides of one edge in opposite directions pair up, first those with the same vertices; what is left is the border.
  void pairSides() {
    std::vector<Side> edge;
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      if (begin % kPolled == 0) poll_();
      while (end < sides_.size() && edgeOf(sides_[end]) == edgeOf(sides_[begin])) ++end;
      edge.assign(sides_.begin() + static_cast<std::ptrdiff_t>(begin),
                  sides_.begin() + static_cast<std::ptrdiff_t>(end));
      if (edge.front().fromPlace == edge.front().toPlace) continue;
      pairSome(edge, true);
      pairSome(edge, false);
      border_.insert(border_.end(), edge.begin(), edge.end());
    }
  }

  void pairSome(std::vector<Side>& edge, bool withSameVertices) {
    for (std::size_t i = 0; i < edge.size(); ++i) {
      for (std::size_t k = i + 1; k < edge.size(); ++k) {
        const Side &a = edge[i], &b = edge[k];
        const bool isSame = a.from == b.to && a.to == b.from;
        if (a.fromPlace != b.toPlace || (withSameVertices && !isSame) || groupOf(a) != groupOf(b)) continue;
        parts_.unite(static_cast<Index>(a.triangle), static_cast<Index>(b.triangle));
        if ((!isSame || isCut_) && !isLinked(a)) result_.barriers.push_back({a.from, a.to});
        edge.erase(edge.begin() + static_cast<std::ptrdiff_t>(k));
        edge.erase(edge.begin() + static_cast<std::ptrdiff_t>(i--));
        break;
      }
    }
  }

  /// Cuts sides of the border at the places of others that lie on them: surfaces that are not joined share no vertices.
  /// Whether there was any.
  bool splitBorder() {
    std::vector<Index> places;
    for (const Side& side : border_) places.push_back(static_cast<Index>(side.fromPlace));
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    BoxTree<2> tree;
    tree.build(
        places,
        [this](Index v) {
          const Vec3& p = mesh_.vertices[static_cast<std::size_t>(v)];
          return BoxTree<2>::Bounds{{p.x, p.y}, {p.x, p.y}};
        },
        poll_);
    std::vector<Side> pieces;
    std::vector<std::pair<double, std::uint32_t>> cuts;
    for (std::size_t i = 0; i < border_.size(); ++i) {
      if (i % kPolled == 0) poll_();
      Side side = border_[i];
      findCuts(side, tree, cuts);
      for (const auto& [along, place] : cuts) {
        Side piece = side;
        piece.to = piece.toPlace = side.from = side.fromPlace = place;
        pieces.push_back(piece);
      }
      pieces.push_back(side);
    }
    const bool isAny = pieces.size() > border_.size();
    border_ = std::move(pieces);
    return isAny;
  }

  /// The places between the ends of a side, in its direction.
  void findCuts(const Side& side, const BoxTree<2>& tree, std::vector<std::pair<double, std::uint32_t>>& cuts) const {
    cuts.clear();
    const Vec3 &a = mesh_.vertices[side.fromPlace], &b = mesh_.vertices[side.toPlace];
    const double near = std::ldexp(extent_, kRounding), dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    const BoxTree<2>::Bounds box{{std::min(a.x, b.x) - near, std::min(a.y, b.y) - near},
                                 {std::max(a.x, b.x) + near, std::max(a.y, b.y) + near}};
    tree.visitOverlapping(box, [&](Index v) {
      const auto place = static_cast<std::uint32_t>(v);
      if (place == side.fromPlace || place == side.toPlace) return;
      const double x = mesh_.vertices[place].x - a.x, y = mesh_.vertices[place].y - a.y;
      const double along = (x * dx + y * dy) / length;
      if (along > near && along < length - near && std::abs(dx * y - dy * x) <= near * length)
        cuts.emplace_back(along, place);
    });
    std::sort(cuts.begin(), cuts.end());
  }

  [[nodiscard]] std::uint32_t groupOf(const Side& side) const {
    return groups_.empty() ? 0 : groups_[triangles_[side.triangle]];
  }

  [[nodiscard]] bool isLinked(const Side& side) const {
    return std::binary_search(linked_.begin(), linked_.end(), std::array{side.from, side.to});
  }

  void traceRings(const std::vector<Index>& partOf) {
    std::sort(border_.begin(), border_.end(), [&partOf](const Side& a, const Side& b) {
      return std::tuple(partOf[a.triangle], a.fromPlace, a.toPlace, a.triangle) <
             std::tuple(partOf[b.triangle], b.fromPlace, b.toPlace, b.triangle);
    });
    isUsed_.assign(border_.size(), 0);
    passed_.assign(mesh_.vertices.size(), kNoSide);
    for (std::size_t i = 0; i < border_.size(); ++i) {
      if (i % kPolled == 0) poll_();
      if (isUsed_[i] == 0) traceFrom(i, partOf);
    }
    for (PlanPart& part : result_.parts) std::sort(part.holes.begin(), part.holes.end());
  }

  /// Follows the border from side `first` until it is back; where it passes a place again, a ring is complete.
  void traceFrom(std::size_t first, const std::vector<Index>& partOf) {
    const Index part = partOf[border_[first].triangle];
    std::vector<std::size_t> path;
    for (std::optional<std::size_t> at = first; at; at = sideAfter(*at, part, partOf)) {
      isUsed_[*at] = 1;
      passed_[border_[*at].fromPlace] = path.size();
      path.push_back(*at);
      const std::size_t begin = passed_[border_[*at].toPlace];
      if (begin == kNoSide) continue;
      PlanRing ring;
      for (std::size_t i = begin; i < path.size(); ++i) {
        ring.push_back(border_[path[i]].from);
        passed_[border_[path[i]].fromPlace] = kNoSide;
      }
      path.resize(begin);
      addRing(result_.parts[part], std::move(ring));
    }
    for (const std::size_t side : path) passed_[border_[side].fromPlace] = kNoSide;
  }

  /// The border goes on with the side that bounds the same corner of the walkable area: the first one clockwise from
  /// the way back.
  std::optional<std::size_t> sideAfter(std::size_t side, Index part, const std::vector<Index>& partOf) const {
    const std::uint32_t place = border_[side].toPlace;
    const auto begin = std::lower_bound(border_.begin(), border_.end(), std::pair(part, place),
                                        [&partOf](const Side& s, const std::pair<Index, std::uint32_t>& value) {
                                          return std::pair(partOf[s.triangle], s.fromPlace) < value;
                                        });
    std::optional<std::size_t> best;
    for (auto s = begin; s != border_.end() && partOf[s->triangle] == part && s->fromPlace == place; ++s) {
      const auto i = static_cast<std::size_t>(s - border_.begin());
      if (isUsed_[i] != 0) continue;
      if (!best || isBefore(border_[side].from, place, s->to, border_[*best].to)) best = i;
    }
    return best;
  }

  /// True when, clockwise round `middle` and from the direction of `back`, a comes before b.
  [[nodiscard]] bool isBefore(std::uint32_t back, std::uint32_t middle, std::uint32_t a, std::uint32_t b) const {
    const int sectorA = sectorOf(back, middle, a), sectorB = sectorOf(back, middle, b);
    if (sectorA != sectorB) return sectorA < sectorB;
    return turn(middle, a, b) < 0;
  }
  /// 0: less than half a turn clockwise from the direction of `back`; 1: opposite; 2: more; 3: the direction itself.
  [[nodiscard]] int sectorOf(std::uint32_t back, std::uint32_t middle, std::uint32_t to) const {
    const int side = turn(middle, back, to);
    if (side != 0) return side < 0 ? 0 : 2;
    const Vec3 u = mesh_.vertices[back] - mesh_.vertices[middle], w = mesh_.vertices[to] - mesh_.vertices[middle];
    return u.x * w.x + u.y * w.y < 0 ? 1 : 3;
  }
  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return facing(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
  }

  void addRing(PlanPart& part, PlanRing ring) const {
    if (ring.size() < 2 || (rule_ == EdgeRule::SamePlace && isSliver(ring))) return;
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    const double area = doubleAreaOf(mesh_, ring);
    // Folds by rounding can make two outlines that go round; the larger one counts.
    if (area <= 0)
      part.holes.push_back(std::move(ring));
    else if (part.outer.empty() || area > doubleAreaOf(mesh_, part.outer))
      part.outer = std::move(ring);
  }

  [[nodiscard]] bool isSliver(const PlanRing& ring) const {
    double around = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 d = mesh_.vertices[ring[(i + 1) % ring.size()]] - mesh_.vertices[ring[i]];
      around += std::hypot(d.x, d.y);
    }
    return std::abs(doubleAreaOf(mesh_, ring)) <= std::ldexp(extent_ * around, kRounding);
  }

  const NavigationMesh& mesh_;
  std::span<const std::uint32_t> triangles_, groups_;
  EdgeRule rule_;
  Poll poll_;
  DisjointSets parts_;
  std::vector<Side> sides_, border_;
  std::vector<char> isUsed_;
  std::vector<std::size_t> passed_;                   ///< index in the path at which a side leaves the place
  std::vector<std::array<std::uint32_t, 2>> linked_;  ///< edges over which a step leads
  bool isCut_ = false;  ///< sides were cut at places, so that equal vertices say nothing any more
  double extent_ = 0;
  PlanOutline result_;
};

}  // namespace

PlanOutline outlineInPlan(const NavigationMesh& mesh, std::span<const std::uint32_t> triangles, EdgeRule rule,
                          Poll poll, std::span<const std::uint32_t> groups) {
  return Outliner(mesh, triangles, rule, poll, groups).outline();
}

double doubleAreaOf(const NavigationMesh& mesh, const PlanRing& ring) {
  // Relative to the first vertex, so that a small ring far from the origin keeps its digits.
  const Vec3& origin = mesh.vertices[ring.front()];
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec3 a = mesh.vertices[ring[i]] - origin, b = mesh.vertices[ring[i + 1]] - origin;
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

NumberedParts numberParts(const NavigationMesh& mesh, Poll poll) {
  Index count = 0;
  std::vector<Index> part = findParts(mesh.triangles, mesh.vertices.size(), count, poll);
  DisjointSets sets(static_cast<std::size_t>(count));
  for (const StepLink& link : mesh.links) sets.unite(part[link.fromTriangle], part[link.toTriangle]);
  const std::vector<Index> joined = sets.numbers(count);
  std::vector<double> areas(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < part.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    part[t] = joined[part[t]];
    areas[part[t]] += areaOf(mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]);
  }
  std::vector<std::uint32_t> order(areas.size()), rank(areas.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&areas](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
  NumberedParts parts;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = i;
    parts.areas.push_back(areas[order[i]]);
  }
  parts.ofTriangle.reserve(part.size());
  for (const Index p : part) parts.ofTriangle.push_back(rank[p]);
  return parts;
}

}  // namespace footfall::detail
