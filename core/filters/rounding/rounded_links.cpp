// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/rounded_links.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

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
      : mesh_(mesh),
        corners_(mesh.triangles),
        first_(std::bit_ceil(2 * sides.size() + 1), -1),
        sides_(std::move(sides)),
        next_(sides_.size(), -1) {
    std::sort(sides_.begin(), sides_.end());
    // Those that begin at a place come in the order of their numbers.
    for (std::size_t i = sides_.size(); i-- > 0;)
      next_[i] = std::exchange(first_[bucketOf(begin(sides_[i]))], static_cast<Index>(i));
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
    const Vec3 way = to - at;
    Index best = -1;
    double straightest = 0;
    for (Index i = first_[bucketOf(at)]; i >= 0; i = next_[i]) {
      const Index side = sides_[i];
      if (!(begin(side) == at)) continue;
      if (end(side) == to) return side;
      const Vec3 step = end(side) - at;
      const double along = dot(step, way), straightness = along / std::sqrt(dot(step, step));
      if (along >= dot(way, way) || straightness <= straightest) continue;
      straightest = straightness;
      best = side;
    }
    return best;
  }

  [[nodiscard]] std::size_t bucketOf(const Vec3& place) const {
    std::uint64_t key = 0;
    for (const double x : {place.x, place.y, place.z}) {
      key = (key ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;  // -0 equals 0
      key ^= key >> 32;
    }
    return static_cast<std::size_t>(key) & (first_.size() - 1);
  }

  const NavigationMesh& mesh_;
  TriangleCorners corners_;
  std::vector<Index> first_;  ///< for each bucket of places the first side that begins there, in sides_
  std::vector<Index> sides_;  ///< of borders
  std::vector<Index> next_;   ///< for each side the next one in its bucket
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
