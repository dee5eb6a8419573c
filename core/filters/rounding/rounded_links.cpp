// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/rounded_links.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/parallel_sort.hpp"
#include "core/base/sorted_list.hpp"
#include "core/base/vector.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "core/mesh/triangle_corners.hpp"

namespace footfall::detail {
namespace {

using Place = std::tuple<double, double, double>;
Place placeOf(const Vec3& v) { return {v.x, v.y, v.z}; }

class Borders {
 public:
  Borders(const NavigationMesh& mesh, std::vector<Index> sides)
      : mesh_(mesh), corners_(mesh.triangles), sides_(std::move(sides)) {
    parallelSort(sides_.begin(), sides_.end(),
                 [&](Index a, Index b) { return std::pair(placeOf(begin(a)), a) < std::pair(placeOf(begin(b)), b); });
  }

  /// The sides that lead from one place to another, or nothing. Where a border was divided, it goes on with the side
  /// that deviates least; it must arrive exactly.
  [[nodiscard]] std::vector<Index> chain(const Vec3& from, const Vec3& to) const {
    constexpr std::size_t kMostPieces = 64;
    std::vector<Index> result;
    for (Vec3 at = from; result.size() < kMostPieces;) {
      const Index side = nextSide(at, to);
      if (side < 0) break;
      result.push_back(side);
      at = end(side);
      if (at == to) return result;
    }
    return {};
  }
  [[nodiscard]] std::array<std::uint32_t, 2> verticesOf(Index side) const {
    return {static_cast<std::uint32_t>(corners_.beginOf(side)), static_cast<std::uint32_t>(corners_.endOf(side))};
  }

 private:
  [[nodiscard]] const Vec3& begin(Index side) const { return mesh_.vertices[corners_.beginOf(side)]; }
  [[nodiscard]] const Vec3& end(Index side) const { return mesh_.vertices[corners_.endOf(side)]; }

  [[nodiscard]] Index nextSide(const Vec3& at, const Vec3& to) const {
    const auto first = std::lower_bound(sides_.begin(), sides_.end(), at, [&](Index side, const Vec3& place) {
      return placeOf(begin(side)) < placeOf(place);
    });
    const Vec3 way = to - at;
    Index best = -1;
    double straightest = 0;
    for (auto it = first; it != sides_.end() && begin(*it) == at; ++it) {
      if (end(*it) == to) return *it;
      const Vec3 step = end(*it) - at;
      const double along = dot(step, way), straightness = along / std::sqrt(dot(step, step));
      if (along >= dot(way, way) || straightness <= straightest) continue;
      straightest = straightness;
      best = *it;
    }
    return best;
  }

  const NavigationMesh& mesh_;
  TriangleCorners corners_;
  std::vector<Index> sides_;  ///< of borders, by the places where they begin
};

}  // namespace

std::vector<StepLink> roundLinks(const std::vector<MeshLink>& links, const std::vector<Vec3>& places,
                                 const std::vector<std::array<Vec3, 2>>& moved, std::vector<Index> borderSides,
                                 const NavigationMesh& product) {
  std::vector<StepLink> result;
  if (links.empty()) return result;
  const Borders borders(product, std::move(borderSides));
  std::map<Place, Vec3> movedTo;
  for (auto it = moved.rbegin(); it != moved.rend(); ++it) {
    const auto later = movedTo.find(placeOf((*it)[1]));
    movedTo[placeOf((*it)[0])] = later == movedTo.end() ? (*it)[1] : later->second;
  }
  const auto chainOf = [&](const std::array<Index, 2>& edge) {
    std::array<std::vector<Vec3>, 2> ends;
    for (int i = 0; i < 2; ++i) {
      ends[i].push_back(places[edge[i]]);
      if (const auto it = movedTo.find(placeOf(places[edge[i]])); it != movedTo.end()) ends[i].push_back(it->second);
    }
    for (const Vec3& from : ends[0])
      for (const Vec3& to : ends[1]) {
        if (from == to) continue;
        if (std::vector<Index> chain = borders.chain(from, to); !chain.empty()) return chain;
      }
    return std::vector<Index>{};
  };
  for (const MeshLink& link : links) {
    const std::vector<Index> from = chainOf(link.from), to = chainOf(link.to);
    if (from.size() != to.size()) continue;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Index a = from[i], b = to[to.size() - 1 - i];
      StepLink rounded{borders.verticesOf(a), borders.verticesOf(b), static_cast<std::uint32_t>(a / 3),
                       static_cast<std::uint32_t>(b / 3), 0};
      for (int end = 0; end < 2; ++end)
        rounded.height = std::max(
            rounded.height, std::fabs(product.vertices[rounded.from[end]].z - product.vertices[rounded.to[1 - end]].z));
      rounded.width = widthOf(rounded, product.vertices);
      if (rounded.width > 0) {
        rounded.kind = StepKind::Gap;
        if (!link.isGap || bridgeOver(rounded, product.vertices).empty()) continue;
      }
      if (rounded.to < rounded.from) {
        std::swap(rounded.from, rounded.to);
        std::swap(rounded.fromTriangle, rounded.toTriangle);
      }
      result.push_back(rounded);
    }
  }
  const auto keyOf = [](const StepLink& link) { return std::array{link.from, link.to}; };
  sortOnceBy(result, keyOf);
  return result;
}

}  // namespace footfall::detail
