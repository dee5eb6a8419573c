// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/rounded_drops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/base/sorted_list.hpp"
#include "core/mesh/adjacency.hpp"

namespace footfall::detail {
namespace {

using Place = std::tuple<double, double, double>;
Place placeOf(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 asVector(const Place& p) { return {std::get<0>(p), std::get<1>(p), std::get<2>(p)}; }

/// Sides and triangles of a product by the places of their corners.
class ProductPlaces {
 public:
  ProductPlaces(const NavigationMesh& mesh, const std::vector<std::uint32_t>& origins, const Poll& poll) : mesh_(mesh) {
    const TriangleCorners corners(mesh.triangles);
    const Adjacency topology = findEdges(corners, mesh.vertices.size());
    for (Index e = 0; e < topology.edgeCount(); ++e) {
      const auto sides = topology.sidesOf(e);
      if (sides.size() != 1) continue;
      sides_.try_emplace(
          {placeOf(mesh.vertices[corners.beginOf(sides[0])]), placeOf(mesh.vertices[corners.endOf(sides[0])])},
          sides[0]);
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      std::vector<std::uint32_t>& own = ofSource_[mesh.sourceTriangles[t]].triangles;
      if (own.size() % kPolled == kPolled - 1) poll();
      own.push_back(t);
    }
    for (auto& [source, pieces] : ofSource_)
      if (pieces.triangles.size() > kManyPieces) buildTree(pieces, poll);
    for (const Vec3& v : mesh.vertices)
      hair_ = std::max({hair_, std::fabs(v.x) * 0x1p-40, std::fabs(v.y) * 0x1p-40, std::fabs(v.z) * 0x1p-40});
    for (const std::uint32_t origin : origins) {
      if (origin + 2 > firstOf_.size()) firstOf_.resize(origin + std::size_t{2}, 0);
      ++firstOf_[origin + 1];
    }
    std::partial_sum(firstOf_.begin(), firstOf_.end(), firstOf_.begin());
    ofOrigins_.resize(origins.size());
    std::vector<std::uint32_t> next = firstOf_;
    for (std::uint32_t t = 0; t < origins.size(); ++t) ofOrigins_[next[origins[t]]++] = t;
  }

  [[nodiscard]] std::optional<Index> side(const Place& from, const Place& to) const {
    const auto found = sides_.find({from, to});
    return found == sides_.end() ? std::nullopt : std::optional(found->second);
  }

  /// The triangle of a source triangle that holds a place best: farthest inside, or least outside. What is left of a
  /// triangle of the mesh is looked at first; the others only where it does not hold the place by more than hair_.
  ///
  /// M is the largest coordinate, and hair_ is 2^-40 M. The result is that of a search through all triangles near the
  /// place, because
  /// - insideOf() is off by less than 2^-48 M. With u = 2^-53 and the difference e of the place and a corner, at most
  ///   2 sqrt(2) M long, its products are off by 3 u, their difference by 4 u |d| |e| in all (Cauchy-Schwarz), and the
  ///   quotient by |d| by 8 u |e| < 23 u M.
  /// - Pieces of a source triangle do not overlap before rounding, and afterwards in no disc of a radius of 2^-41 M:
  ///   rounding moves a corner by at most 2^-53 M, and repairs no edge by more than 2^-42 M (rounded_mesh.hpp). A
  ///   triangle that holds the place as well as one that is more than hair_ inside would share a disc of a radius above
  ///   2^-40 M - 2^-47 M with it.
  /// - A place is a mean of doubles of its exact triangle, off by less than 2^-49 M. What stands for that triangle in
  ///   the product is less than 2^-41 M away, so the search within hair_ finds it. Where repairs dropped it at the
  ///   border, the last search takes the least outside of all.
  [[nodiscard]] std::optional<std::uint32_t> triangle(Index origin, std::uint32_t source, const Vec3& place) const {
    Best own;
    if (static_cast<std::size_t>(origin) + 1 < firstOf_.size())
      for (std::uint32_t i = firstOf_[origin]; i < firstOf_[origin + 1]; ++i)
        own.take(ofOrigins_[i], insideOf(ofOrigins_[i], place));
    if (own.inside > hair_) return own.triangle;
    const auto found = ofSource_.find(source);
    if (found == ofSource_.end()) return std::nullopt;
    const Pieces& pieces = found->second;
    const auto bestWithin = [&](double around) {
      Best best;
      pieces.tree.visitOverlapping({{place.x - around, place.y - around}, {place.x + around, place.y + around}},
                                   [&](Index i) {
                                     const std::uint32_t t = pieces.triangles[static_cast<std::size_t>(i)];
                                     best.take(t, insideOf(t, place));
                                   });
      return best;
    };
    // A triangle that holds the place touches it with its box. Beyond the tip of a needle insideOf() is near 0 far
    // away, so those that are near come first.
    if (const Best best = bestWithin(0); best.inside > 0) return best.triangle;
    if (const Best best = bestWithin(hair_); best.inside >= -hair_) return best.triangle;
    Best best;
    for (const std::uint32_t t : pieces.triangles) best.take(t, insideOf(t, place));
    return best.triangle;
  }

 private:
  using Tree = BoxTree<2>;
  /// What is left of a source triangle.
  struct Pieces {
    std::vector<std::uint32_t> triangles;
    Tree tree;  ///< over places in the list; empty where there are few
  };
  struct Best {
    std::optional<std::uint32_t> triangle;
    double inside = -std::numeric_limits<double>::infinity();

    void take(std::uint32_t other, double othersInside) {
      if (!(othersInside > inside) && !(othersInside == inside && triangle && other < *triangle)) return;
      triangle = other;
      inside = othersInside;
    }
  };
  static constexpr std::size_t kManyPieces = 32, kPolled = 65536;

  void buildTree(Pieces& pieces, const Poll& poll) const {
    std::vector<Index> all(pieces.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    pieces.tree.build(
        all,
        [&](Index i) {
          const auto& [a, b, c] = mesh_.triangles[pieces.triangles[static_cast<std::size_t>(i)]];
          const Vec3 &p = mesh_.vertices[a], &q = mesh_.vertices[b], &r = mesh_.vertices[c];
          return Tree::Bounds{{std::min({p.x, q.x, r.x}), std::min({p.y, q.y, r.y})},
                              {std::max({p.x, q.x, r.x}), std::max({p.y, q.y, r.y})}};
        },
        poll);
  }

  /// The distance of a place from the nearest side of a triangle, or minus that from the farthest one beyond.
  [[nodiscard]] double insideOf(std::uint32_t t, const Vec3& place) const {
    double inside = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = mesh_.vertices[mesh_.triangles[t][k]], &b = mesh_.vertices[mesh_.triangles[t][next(k)]];
      const double dx = b.x - a.x, dy = b.y - a.y;
      inside = std::min(inside, (dx * (place.y - a.y) - dy * (place.x - a.x)) / std::hypot(dx, dy));
    }
    return inside;
  }

  const NavigationMesh& mesh_;
  std::map<std::pair<Place, Place>, Index> sides_;  ///< keyed by the border
  std::map<std::uint32_t, Pieces> ofSource_;
  double hair_ = 0;  ///< more than rounding and repairs move anything; see triangle()
  /// Triangles in the order of their origins, and the place of the first of each origin.
  std::vector<std::uint32_t> ofOrigins_, firstOf_;
};

Vec3 unscaled(const std::array<double, 3>& p, int scale) {
  return {std::ldexp(p[0], -scale), std::ldexp(p[1], -scale), std::ldexp(p[2], -scale)};
}

}  // namespace

std::vector<DropLink> roundDrops(const WalkableState& state, const std::vector<Vec3>& places,
                                 const std::vector<std::array<Vec3, 2>>& moved, const NavigationMesh& product,
                                 const std::vector<std::uint32_t>& origins, Poll poll) {
  std::vector<DropLink> result;
  const WalkableMesh& mesh = *state.mesh;
  if (mesh.drops.empty()) return result;
  const SourceMesh& source = state.kernel->mesh();
  const ProductPlaces known(product, origins, poll);
  std::map<Place, Place> movedTo;
  for (auto it = moved.rbegin(); it != moved.rend(); ++it) {
    const auto later = movedTo.find(placeOf((*it)[1]));
    movedTo[placeOf((*it)[0])] = later == movedTo.end() ? placeOf((*it)[1]) : later->second;
  }
  const auto placeNow = [&](Index vertex) {
    const Place place = placeOf(places[vertex]);
    const auto now = movedTo.find(place);
    return now == movedTo.end() ? place : now->second;
  };
  for (const MeshDrop& drop : mesh.drops) {
    poll();
    auto side = known.side(placeOf(places[drop.edge[0]]), placeOf(places[drop.edge[1]]));
    if (!side) side = known.side(placeNow(drop.edge[0]), placeNow(drop.edge[1]));
    if (!side) continue;
    DropLink link;
    for (const int end : {0, 1}) {
      link.from[end] = product.triangles[*side / 3][end == 0 ? *side % 3 : next(*side % 3)];
      link.start[end] = unscaled(drop.start[end], source.grid.scaleExponent());
      link.landing[end] = unscaled(drop.landing[end], source.grid.scaleExponent());
      link.depth = std::max(link.depth, link.start[end].z - link.landing[end].z);
    }
    link.fromTriangle = static_cast<std::uint32_t>(*side / 3);
    link.width = std::hypot(link.start[1].x - link.start[0].x, link.start[1].y - link.start[0].y);
    // A place a little inside of the triangle of the landing, to distinguish it from neighbours on the other side of
    // its border.
    constexpr double kInside = 0x1p-10;
    const MeshTriangle& t = mesh.triangles[drop.triangle];
    Vec3 within{};
    for (const Index corner : t.corners) {
      const Vec3 p = asVector(placeNow(corner));
      within = {within.x + p.x * (kInside / 3), within.y + p.y * (kInside / 3), 0};
    }
    for (const Vec3& p : link.landing)
      within = {within.x + p.x * ((1 - kInside) / 2), within.y + p.y * ((1 - kInside) / 2), 0};
    const auto landing = known.triangle(drop.triangle, source.inputTriangles[t.face], within);
    if (!landing) continue;
    link.toTriangle = *landing;
    result.push_back(link);
  }
  const auto keyOf = [](const DropLink& d) {
    return std::tuple(d.from, d.toTriangle, placeOf(d.start[0]), placeOf(d.start[1]), placeOf(d.landing[0]),
                      placeOf(d.landing[1]));
  };
  sortOnceBy(result, keyOf);
  return result;
}

}  // namespace footfall::detail
