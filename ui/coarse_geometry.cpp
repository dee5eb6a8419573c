// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/coarse_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace footfall {
namespace {

using Point = std::array<float, 3>;

double areaOf(const Point& a, const Point& b, const Point& c) {
  const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const std::array<double, 3> v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

}  // namespace

std::vector<SurfaceVertex> coarsened(const std::vector<SurfaceVertex>& surface, std::vector<std::uint32_t>& kept) {
  kept.clear();
  std::vector<SurfaceVertex> coarse;
  if (surface.size() / 3 <= kCoarseAbove) return coarse;
  Point lower = surface.front().position;
  double area = 0;
  for (std::size_t v = 0; v + 2 < surface.size(); v += 3) {
    area += areaOf(surface[v].position, surface[v + 1].position, surface[v + 2].position);
    for (std::size_t axis = 0; axis < 3; ++axis) lower[axis] = std::min(lower[axis], surface[v].position[axis]);
  }
  // A surface of this area has two triangles for each cell that it goes through.
  const double cell = std::sqrt(2 * area / static_cast<double>(kCoarseAim));
  if (!(cell > 0)) return coarse;
  std::unordered_map<std::uint64_t, std::uint32_t> cells;  // to the first corner in each
  cells.reserve(kCoarseAim);
  const auto cornerOf = [&](std::uint32_t vertex) {
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double steps = std::floor((surface[vertex].position[axis] - lower[axis]) / cell);
      key = key << 21U | static_cast<std::uint64_t>(std::clamp(steps, 0.0, 2097151.0));
    }
    return cells.try_emplace(key, vertex).first->second;
  };
  std::unordered_set<std::uint64_t> known;
  known.reserve(2 * kCoarseAim);
  for (std::size_t v = 0; v + 2 < surface.size(); v += 3) {
    const auto first = static_cast<std::uint32_t>(v);
    const std::array<std::uint32_t, 3> corners{cornerOf(first), cornerOf(first + 1), cornerOf(first + 2)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    std::array<std::uint64_t, 3> sorted{corners[0], corners[1], corners[2]};
    std::ranges::sort(sorted);
    // Two triangles in one place: one is enough. That the sums of two others agree costs one triangle of a picture.
    if (!known.insert(sorted[0] * 0x9E3779B97F4A7C15ULL ^ sorted[1] * 0xC2B2AE3D27D4EB4FULL ^ sorted[2]).second)
      continue;
    for (std::size_t k = 0; k < 3; ++k) {
      coarse.push_back(surface[v + k]);
      coarse.back().position = surface[corners[k]].position;
    }
    kept.push_back(first / 3);
  }
  return coarse;
}

}  // namespace footfall
