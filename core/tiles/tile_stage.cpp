// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace footfall::detail {
namespace {

bool touchAlong(const Box& a, const Box& b, std::size_t axis) {
  return a.lower[axis] <= b.upper[axis] && b.lower[axis] <= a.upper[axis];
}

}  // namespace

// A rounded place is at most half a unit in the last place away.
Box boxAround(std::span<const Vec3> places) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Vec3& place : places) {
    const std::array<double, 3> numbers{place.x, place.y, place.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], std::nextafter(numbers[axis], -kInfinity));
      box.upper[axis] = std::max(box.upper[axis], std::nextafter(numbers[axis], kInfinity));
    }
  }
  return box;
}

StoredTile storedTileOf(std::size_t number, const Tile& tile) {
  return {number, tile.triangles.size(), boxAround(tile.places)};
}

void TileStage::add(const Tile& tile, std::vector<StoredTile>& to) {
  if (tile.triangles.empty()) return;
  to.push_back(storedTileOf(count++, tile));
  store.add(tile);
}

bool touchInPlan(const Box& a, const Box& b) { return touchAlong(a, b, 0) && touchAlong(a, b, 1); }
bool touch(const Box& a, const Box& b) { return touchInPlan(a, b) && touchAlong(a, b, 2); }

}  // namespace footfall::detail
