// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/convex_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/vector.hpp"

namespace footfall::detail {
namespace {

using EdgeNumber = std::uint32_t;
constexpr EdgeNumber kNone = kNoPolygon;

/// Polygons as rings of directed edges, which begin as the rings of the triangles.
class PolygonMerger {
 public:
  PolygonMerger(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                std::span<const std::uint32_t> groups, const MergeRules& rules)
      : vertices_(vertices), groups_(groups), rules_(rules), twin_(oppositeEdges(triangles)) {
    const auto count = static_cast<std::uint32_t>(triangles.size());
    origin_.resize(3 * triangles.size());
    next_.resize(origin_.size());
    previous_.resize(origin_.size());
    for (std::uint32_t t = 0; t < count; ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        origin_[3 * t + k] = triangles[t][k];
        next_[3 * t + k] = 3 * t + (k + 1) % 3;
        previous_[3 * t + k] = 3 * t + (k + 2) % 3;
      }
    polygons_.resize(count);
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::uint32_t t = 0; t < count; ++t) {
      const Vec3& a = vertices[triangles[t][0]];
      const Vec3 normal = normalOf(a, vertices[triangles[t][1]], vertices[triangles[t][2]]);
      polygons_[t] = {3 * t, 3, 1, a, normal, length(normal)};
    }
    double largest = 0;
    for (const Vec3& p : vertices) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    slack_ = std::ldexp(largest, -23);
  }

  void mergeAll(Poll poll) {
    constexpr std::size_t kEdgesPerPoll = 4096;
    std::vector<EdgeNumber> edges = longestFirst();
    // A union that is not convex can become so as a polygon beside it grows, so the pass is repeated until nothing
    // changes.
    for (bool isChanged = true; isChanged;) {
      isChanged = false;
      for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i % kEdgesPerPoll == 0) poll();
        if (twin_[edges[i]] != kNone) isChanged = tryEdge(edges[i]) || isChanged;
      }
      std::erase_if(edges, [&](EdgeNumber e) { return twin_[e] == kNone; });
    }
  }

  [[nodiscard]] ConvexPolygons result() {
    ConvexPolygons result;
    std::vector<std::uint32_t> number(parent_.size(), kNone);
    std::uint32_t count = 0;
    result.polygonOf.resize(parent_.size());
    for (std::uint32_t t = 0; t < parent_.size(); ++t) {
      std::uint32_t& of = number[find(t)];
      if (of == kNone) of = count++;
      result.polygonOf[t] = of;
    }
    result.first.reserve(count + 1);
    for (std::uint32_t t = 0; t < parent_.size(); ++t) {
      if (result.polygonOf[t] != result.size()) continue;  // a later triangle of a polygon
      const EdgeNumber start = polygons_[find(t)].edge;
      EdgeNumber e = start;
      do {
        result.corners.push_back(origin_[e]);
        result.neighbours.push_back(twin_[e] == kNone ? kNone : result.polygonOf[twin_[e] / 3]);
        e = next_[e];
      } while (e != start);
      result.first.push_back(static_cast<std::uint32_t>(result.corners.size()));
    }
    return result;
  }

 private:
  struct Polygon {
    EdgeNumber edge;  ///< any edge of its ring
    std::size_t corners, triangles;
    Vec3 point, normal;  ///< plane of its largest triangle
    double size;         ///< twice the area of that triangle
  };

  std::uint32_t find(std::uint32_t t) {
    while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
    return t;
  }

  std::vector<EdgeNumber> longestFirst() const {
    std::vector<EdgeNumber> edges;
    std::vector<double> lengths(origin_.size());
    for (EdgeNumber e = 0; e < origin_.size(); ++e) {
      if (twin_[e] == kNone) continue;
      const Vec3 d = vertices_[origin_[next_[e]]] - vertices_[origin_[e]];
      lengths[e] = d.x * d.x + d.y * d.y;
      edges.push_back(e);
    }
    std::stable_sort(edges.begin(), edges.end(), [&](EdgeNumber a, EdgeNumber b) { return lengths[a] > lengths[b]; });
    return edges;
  }

  /// The sign of the turn seen from above: positive to the left, 0 straight on; a reversal counts as a turn to the
  /// right.
  [[nodiscard]] int turn(std::uint32_t from, std::uint32_t corner, std::uint32_t to) const {
    const Vec3 in = vertices_[corner] - vertices_[from], out = vertices_[to] - vertices_[corner];
    const double side = in.x * out.y - in.y * out.x;
    const double allowed = slack_ * std::hypot(in.x + out.x, in.y + out.y);
    if (std::fabs(side) > allowed) return side > 0 ? 1 : -1;
    return in.x * out.x + in.y * out.y > 0 ? 0 : -1;
  }

  [[nodiscard]] bool isFlat(const Polygon& a, const Polygon& b) const {
    if (!rules_.maxHeight) return true;
    const auto& [plane, other] = a.size >= b.size ? std::pair(&a, &b) : std::pair(&b, &a);
    if (!(plane->normal.z > 0)) return false;
    EdgeNumber e = other->edge;
    do {
      if (std::fabs(dot(plane->normal, vertices_[origin_[e]] - plane->point)) > *rules_.maxHeight * plane->normal.z)
        return false;
      e = next_[e];
    } while (e != other->edge);
    return true;
  }

  /// Merges the polygons on either side of the edge where that is allowed. Returns whether it did.
  bool tryEdge(EdgeNumber e) {
    const std::uint32_t left = find(e / 3), right = find(twin_[e] / 3);
    if (left == right) return false;
    if (!groups_.empty() && groups_[left] != groups_[right]) return false;
    Polygon &a = polygons_[left], &b = polygons_[right];
    if (a.triangles + b.triangles > rules_.maxTriangles) return false;
    // The whole side that both share: from `begin` to `end` in a, the twins backwards in b.
    EdgeNumber begin = e, end = e;
    std::size_t shared = 1;
    for (; shared < a.corners && isTwin(previous_[begin], next_[twin_[begin]]); ++shared) begin = previous_[begin];
    for (; shared < a.corners && isTwin(next_[end], previous_[twin_[end]]); ++shared) end = next_[end];
    if (shared >= a.corners || shared >= b.corners) return false;  // one polygon fills a hole of the other
    const std::size_t corners = a.corners + b.corners - 2 * shared;
    if (corners < 3 || corners > rules_.maxCorners) return false;
    const EdgeNumber intoA = previous_[begin], outOfB = next_[twin_[begin]];
    const EdgeNumber intoB = previous_[twin_[end]], outOfA = next_[end];
    if (turn(origin_[intoA], origin_[begin], origin_[next_[outOfB]]) < 0) return false;
    if (turn(origin_[intoB], origin_[outOfA], origin_[next_[outOfA]]) < 0) return false;
    if (!isFlat(a, b)) return false;

    for (EdgeNumber gone = begin;; gone = next_[gone]) {
      twin_[twin_[gone]] = kNone;
      twin_[gone] = kNone;
      if (gone == end) break;
    }
    connect(intoA, outOfB);
    connect(intoB, outOfA);
    const Polygon& larger = a.size >= b.size ? a : b;
    const Polygon merged{intoA, corners, a.triangles + b.triangles, larger.point, larger.normal, larger.size};
    parent_[right] = left;
    polygons_[left] = merged;
    leaveOutStraight(outOfB);
    leaveOutStraight(outOfA);
    return true;
  }

  [[nodiscard]] bool isTwin(EdgeNumber a, EdgeNumber b) const { return twin_[a] == b && b != kNone; }

  void connect(EdgeNumber before, EdgeNumber after) {
    next_[before] = after;
    previous_[after] = before;
  }

  /// Removes the vertex that `e` starts from, where the border is straight, also in height, and only this polygon and
  /// one other have the vertex.
  void leaveOutStraight(EdgeNumber e) {
    const EdgeNumber before = previous_[e];
    if (twin_[e] == kNone || twin_[before] == kNone || next_[twin_[e]] != twin_[before]) return;
    const std::uint32_t here = find(e / 3), there = find(twin_[e] / 3);
    if (here == there || polygons_[here].corners <= 3 || polygons_[there].corners <= 3) return;
    const std::uint32_t from = origin_[before], to = origin_[next_[e]];
    if (turn(from, origin_[e], to) != 0) return;
    const Vec3 whole = vertices_[to] - vertices_[from], part = vertices_[origin_[e]] - vertices_[from];
    if (length(cross(whole, part)) > 2 * slack_ * length(whole)) return;
    // `before` gets the end of `e`, and the twin of `e` gets the end of the twin of `before`.
    const EdgeNumber back = twin_[e], gone = twin_[before];
    connect(before, next_[e]);
    connect(back, next_[gone]);
    twin_[before] = back;
    twin_[back] = before;
    twin_[e] = twin_[gone] = kNone;
    polygons_[here].edge = before;
    polygons_[there].edge = back;
    --polygons_[here].corners;
    --polygons_[there].corners;
  }

  std::span<const Vec3> vertices_;
  std::span<const std::uint32_t> groups_;
  const MergeRules& rules_;
  std::vector<EdgeNumber> twin_, next_, previous_;
  std::vector<std::uint32_t> origin_;
  std::vector<Polygon> polygons_;      ///< valid for triangles that are their own parents
  std::vector<std::uint32_t> parent_;  ///< parent of each triangle; a root stands for its polygon
  double slack_ = 0;
};

}  // namespace

std::vector<std::uint32_t> oppositeEdges(std::span<const Triangle> triangles) {
  struct Side {
    std::uint64_t key;
    std::uint32_t edge;
    bool isUp;  ///< from the lower vertex number to the higher one
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t e = 0; e < 3 * triangles.size(); ++e) {
    const std::uint64_t from = triangles[e / 3][e % 3], to = triangles[e / 3][(e + 1) % 3];
    sides.push_back({std::min(from, to) << 32 | std::max(from, to), e, from < to});
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.key != b.key ? a.key < b.key : a.edge < b.edge; });
  std::vector<std::uint32_t> opposite(sides.size(), kNone);
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    for (end = i; end < sides.size() && sides[end].key == sides[i].key;) ++end;
    if (end - i != 2 || sides[i].isUp == sides[i + 1].isUp) continue;
    opposite[sides[i].edge] = sides[i + 1].edge;
    opposite[sides[i + 1].edge] = sides[i].edge;
  }
  return opposite;
}

ConvexPolygons mergeTriangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> groups, const MergeRules& rules, Poll poll) {
  poll();
  PolygonMerger merger(vertices, triangles, groups, rules);
  merger.mergeAll(poll);
  return merger.result();
}

}  // namespace footfall::detail
