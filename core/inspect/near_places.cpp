// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/near_places.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <vector>

#include "core/environment/coordinate_grid.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kMostPlaces = std::size_t{1} << 16;
constexpr std::size_t kPolled = 1 << 14;

/// A vertex and the place of the grid nearest to it.
struct Rounded {
  GridPlace place;
  std::array<double, 3> vertex;
  auto operator<=>(const Rounded&) const = default;
};

}  // namespace

NearPlaces countNearPlaces(const Environment& environment, Poll poll) {
  if (environment.grid.step > 0) return {};
  GridExtent extent;
  std::vector<char> isCorner(environment.vertices.size(), 0);
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    if (t % kPolled == 0) poll();
    for (const std::uint32_t v : environment.triangles[t]) {
      extent.include(environment.vertices[v]);
      isCorner[v] = 1;
    }
  }
  for (const Vec3& v : environment.vertices) extent.includeVertex(v);
  const double step = extent.isEmpty ? 0 : usualGridStep(extent, environment.metresPerUnit);
  if (step == 0) return {};
  const std::uint64_t parts = std::bit_floor(environment.vertices.size() / kMostPlaces + 1);
  std::vector<Rounded> places;
  for (std::size_t i = 0; i < environment.vertices.size(); ++i) {
    if (i % kPolled == 0) poll();
    if (isCorner[i] == 0) continue;
    const Vec3& v = environment.vertices[i];
    const GridPlace place = gridPlace(v, step);
    if ((GridPlaceHash()(place) & (parts - 1)) == 0) places.push_back({place, {v.x + 0.0, v.y + 0.0, v.z + 0.0}});
  }
  std::sort(places.begin(), places.end());
  NearPlaces result{0, 0, step};
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0 && places[i] == places[i - 1]) continue;
    result.all += parts;
    if (i > 0 && places[i].place == places[i - 1].place) result.count += parts;
  }
  return result;
}

}  // namespace footfall::detail
