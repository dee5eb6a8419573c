// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/edge_splitting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/base/box_tree.hpp"
#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/environment/coordinate_grid.hpp"

namespace footfall::detail {
namespace {

__extension__ using Int128 = __int128;

constexpr std::size_t kMostBeside = 8;
constexpr std::size_t kPerTask = 2048;  // vertices or triangles

struct NearVertex {
  Int128 along = 0;  ///< along the edge; a common scale
  Index place = 0;
};

/// Returns whether p is nearer than one step to the segment from a to b, between its ends, in whole steps. Coordinates
/// are below 2^53, so differences are below 2^54 and products below 2^109.
bool isBeside(const GridPlace& a, const GridPlace& b, const GridPlace& p, Int128& along) {
  std::array<Int128, 3> u{}, w{};
  Int128 length = 0;
  along = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    w[k] = p[k] - a[k];
    length += u[k] * u[k];
    along += u[k] * w[k];
  }
  if (along <= 0 || along >= length) return false;
  constexpr Int128 kMost = Int128{1} << 60;  // squares below 2^120 can be added
  Int128 squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Int128 cross = u[i] * w[j] - u[j] * w[i];
    if (cross >= kMost || cross <= -kMost) return false;  // the edge is shorter than 2^56
    squared += cross * cross;
  }
  return squared < length;
}

/// Edges by the numbers of their places, the smaller one first, and the places beside each, from its first end on.
class NearPlaces {
 public:
  /// The number of the smaller place in the upper half, that of the other in the lower one.
  using Edge = std::uint64_t;

  static Edge edgeOf(Index a, Index b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U | static_cast<std::uint64_t>(std::max(a, b));
  }

  NearPlaces(const std::vector<GridPlace>& places, std::vector<Edge> edges, const Poll& poll)
      : places_(places), edges_(std::move(edges)) {
    parallelSort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    beside_.resize(edges_.size());
    std::vector<Index> ids(places.size());
    std::iota(ids.begin(), ids.end(), 0);
    tree_.build(
        ids, [&](Index place) { return boundsOf(places[place], places[place], 0); }, poll);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto by = [k](const GridPlace& a, const GridPlace& b) { return a[k] < b[k]; };
      const auto [low, high] = std::minmax_element(places.begin(), places.end(), by);
      if (low != places.end()) extent_ = std::max(extent_, static_cast<double>((*high)[k] - (*low)[k]));
    }
    constexpr std::size_t kEdgesPerTask = 256;
    parallelRanges(edges_.size(), kEdgesPerTask, [&](const auto& range) {
      poll();
      for (std::size_t e = range.begin(); e != range.end(); ++e) beside_[e] = search(edges_[e]);
    });
    keepSplitEdges();
  }

  /// The places beside the edge, on the way from a to b.
  [[nodiscard]] std::vector<Index> between(Index a, Index b) const {
    const std::vector<Index>* beside = a == b ? nullptr : find(edgeOf(a, b));
    if (beside == nullptr) return {};
    std::vector<Index> places = *beside;
    if (a > b) std::reverse(places.begin(), places.end());
    return places;
  }

  [[nodiscard]] bool hasBetween(Index a, Index b) const { return a != b && find(edgeOf(a, b)) != nullptr; }

 private:
  using Tree = BoxTree<3>;

  static Tree::Bounds boundsOf(const GridPlace& a, const GridPlace& b, double margin) {
    Tree::Bounds bounds;
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.lower[k] = static_cast<double>(std::min(a[k], b[k])) - margin;
      bounds.upper[k] = static_cast<double>(std::max(a[k], b[k])) + margin;
    }
    return bounds;
  }

  /// Drops the edges without places beside them, so that few are looked up, and for few triangles.
  void keepSplitEdges() {
    isAtSplit_.assign(places_.size(), 0);
    std::size_t kept = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (beside_[e].empty()) continue;
      isAtSplit_[edges_[e] >> 32U] = isAtSplit_[edges_[e] & 0xffffffffU] = 1;
      edges_[kept] = edges_[e];
      if (kept != e) beside_[kept] = std::move(beside_[e]);
      ++kept;
    }
    edges_.resize(kept);
    beside_.resize(kept);
  }

  /// The places beside an edge, or null where there are none.
  [[nodiscard]] const std::vector<Index>* find(Edge edge) const {
    if (isAtSplit_[edge >> 32U] == 0 || isAtSplit_[edge & 0xffffffffU] == 0) return nullptr;
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge);
    if (found == edges_.end() || *found != edge) return nullptr;
    return &beside_[static_cast<std::size_t>(found - edges_.begin())];
  }

  [[nodiscard]] std::vector<Index> search(Edge edge) const {
    const auto first = static_cast<Index>(edge >> 32U), last = static_cast<Index>(edge & 0xffffffffU);
    const GridPlace &a = places_[first], &b = places_[last];
    std::vector<NearVertex> found;
    const auto look = [&](Index place) {
      if (place == first || place == last) return;
      NearVertex near{0, place};
      if (isBeside(a, b, places_[place], near.along)) found.push_back(near);
    };
    // A box around a long slanted edge holds much that is far from it: stretches have smaller ones.
    constexpr std::int64_t kMostStretches = 64;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) length = std::max(length, static_cast<double>(std::abs(b[k] - a[k])));
    const auto count = std::clamp(static_cast<std::int64_t>(kMostStretches * length / std::max(extent_, 1.0)),
                                  std::int64_t{1}, kMostStretches);
    for (std::int64_t i = 0; i < count; ++i) {
      GridPlace from, to;
      for (std::size_t k = 0; k < 3; ++k) {
        from[k] = a[k] + (b[k] - a[k]) / count * i;
        to[k] = i + 1 == count ? b[k] : a[k] + (b[k] - a[k]) / count * (i + 1);
      }
      // Quotients are cut off, by less than `count` steps at the last end.
      tree_.visitOverlapping(boundsOf(from, to, static_cast<double>(count) + 1), look);
    }
    std::sort(found.begin(), found.end(), [](const NearVertex& p, const NearVertex& q) {
      return p.along != q.along ? p.along < q.along : p.place < q.place;
    });
    std::vector<Index> result;
    for (const NearVertex& near : found)
      if (result.empty() || result.back() != near.place) result.push_back(near.place);
    if (result.size() > kMostBeside) result.clear();
    return result;
  }

  const std::vector<GridPlace>& places_;
  std::vector<Edge> edges_;
  std::vector<std::vector<Index>> beside_;
  std::vector<char> isAtSplit_;  ///< by place; true where an edge ends that has places beside it
  Tree tree_;
  double extent_ = 0;
};

using Corners = std::array<Index, 3>;

/// True when the triangle is a line or a place in the plan. Differences of coordinates are below 2^54.
bool isUpright(const GridPlace& a, const GridPlace& b, const GridPlace& c) {
  return Int128{b[0] - a[0]} * (c[1] - a[1]) == Int128{b[1] - a[1]} * (c[0] - a[0]);
}

/// The places that split each edge of a triangle, from its first corner on.
using Between = std::array<std::span<const Index>, 3>;

/// Cuts a triangle at the place in the middle of an edge's places, and so on. Pieces whose corners lie on one edge are
/// left out.
void cut(const Corners& corners, const Between& between, std::vector<Corners>& pieces) {
  std::size_t k = 0;
  while (k < 3 && between[k].empty()) ++k;
  if (k == 3) {
    pieces.push_back(corners);
    return;
  }
  const Index a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
  const std::size_t middle = between[k].size() / 2;
  const Index p = between[k][middle];
  if (p == c) return;
  cut({a, p, c}, {between[k].first(middle), {}, between[(k + 2) % 3]}, pieces);
  cut({p, b, c}, {between[k].subspan(middle + 1), between[(k + 1) % 3], {}}, pieces);
}

}  // namespace

std::uint64_t splitAtNearVertices(Environment& environment, double step, const Poll& poll) {
  std::vector<Triangle>& triangles = environment.triangles;
  if (triangles.size() > kMostSplitTriangles || environment.vertices.size() > kMostSplitVertices) return 0;
  std::vector<GridPlace> places;
  places.reserve(environment.vertices.size());
  for (const Vec3& p : environment.vertices) places.push_back(gridPlace(p, step));
  parallelSort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  poll();
  std::vector<Index> placeOf(environment.vertices.size());
  std::vector<std::uint32_t> vertexAt(places.size());
  parallelRanges(placeOf.size(), kPerTask, [&](const auto& range) {
    poll();
    for (std::size_t v = range.begin(); v != range.end(); ++v)
      placeOf[v] = static_cast<Index>(
          std::lower_bound(places.begin(), places.end(), gridPlace(environment.vertices[v], step)) - places.begin());
  });
  for (std::size_t v = placeOf.size(); v-- > 0;) vertexAt[placeOf[v]] = static_cast<std::uint32_t>(v);
  const std::size_t given = triangles.size();
  const auto cornersAt = [&](std::size_t t) {
    const Triangle& triangle = triangles[t];
    return Corners{placeOf[triangle[0]], placeOf[triangle[1]], placeOf[triangle[2]]};
  };
  // Pieces of a wall would not be upright. A whole one beside the split border of a floor parts no less.
  std::vector<char> maySplit(given);
  parallelRanges(given, kPerTask, [&](const auto& range) {
    poll();
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      const auto [a, b, c] = cornersAt(t);
      maySplit[t] = isUpright(places[a], places[b], places[c]) ? 0 : 1;
    }
  });
  std::vector<NearPlaces::Edge> edges;
  for (std::size_t t = 0; t < given; ++t) {
    if (maySplit[t] == 0) continue;
    const Corners corners = cornersAt(t);
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(NearPlaces::edgeOf(corners[k], corners[(k + 1) % 3]));
  }
  const NearPlaces near(places, std::move(edges), poll);
  std::uint64_t count = 0;

  parallelRanges(given, kPerTask, [&](const auto& range) {
    poll();
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      if (maySplit[t] == 0) continue;
      const auto [a, b, c] = cornersAt(t);
      maySplit[t] = near.hasBetween(a, b) || near.hasBetween(b, c) || near.hasBetween(c, a) ? 1 : 0;
    }
  });
  std::vector<Corners> pieces;
  for (std::size_t t = 0; t < given; ++t) {
    if (maySplit[t] == 0) continue;
    const Corners corners = cornersAt(t);
    std::array<std::vector<Index>, 3> beside;
    for (std::size_t k = 0; k < 3; ++k) beside[k] = near.between(corners[k], corners[(k + 1) % 3]);
    ++count;
    pieces.clear();
    cut(corners, {beside[0], beside[1], beside[2]}, pieces);
    if (pieces.empty()) {
      triangles[t][1] = triangles[t][2];
      continue;
    }
    const auto cornersOf = [&](const Corners& piece) {
      return Triangle{vertexAt[piece[0]], vertexAt[piece[1]], vertexAt[piece[2]]};
    };
    triangles[t] = cornersOf(pieces[0]);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      triangles.push_back(cornersOf(pieces[i]));
      if (!environment.partOf.empty()) environment.partOf.push_back(environment.partOf[t]);
      if (!environment.obstacleOnly.empty()) environment.obstacleOnly.push_back(environment.obstacleOnly[t]);
    }
  }
  return count;
}

}  // namespace footfall::detail
