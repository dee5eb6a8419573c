// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/packed/coarse_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/base/vector.hpp"

namespace footfall::detail {
namespace {

using Corners = std::array<std::uint16_t, 3>;

constexpr std::uint64_t kAllCoarse = 1U << 17U;  // few enough to draw at once
constexpr std::uint64_t kLeast = 16;
constexpr double kMostOfArea = 0.3;

double areaIn(std::span<const Vec3> places, const Corners& corners) {
  const double area = areaOf(places[corners[0]], places[corners[1]], places[corners[2]]);
  return std::isfinite(area) ? area : std::numeric_limits<double>::max();
}

CoarseFace faceOf(std::span<const Vec3> places, const Corners& corners) {
  return {places[corners[0]], places[corners[1]], places[corners[2]]};
}

/// Numbers of the largest triangles, the largest first.
std::vector<std::uint32_t> largestOf(const std::vector<double>& areas, std::size_t most) {
  std::vector<std::uint32_t> largest(areas.size());
  std::iota(largest.begin(), largest.end(), 0U);
  const auto end = largest.begin() + static_cast<std::ptrdiff_t>(std::min(most, largest.size()));
  std::partial_sort(largest.begin(), end, largest.end(), [&](std::uint32_t a, std::uint32_t b) {
    return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
  });
  largest.erase(end, largest.end());
  return largest;
}

/// A cube that holds the middles of the triangles: its lowest corner and its side.
struct Cube {
  Vec3 lower;
  double side = 0;
};

Cube cubeOf(std::span<const Vec3> places, std::span<const Corners> corners) {
  Vec3 lower, upper;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const auto& [a, b, c] = faceOf(places, corners[t]);
    const Vec3 middle{a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3, a.z / 3 + b.z / 3 + c.z / 3};
    if (t == 0) lower = upper = middle;
    lower = {std::min(lower.x, middle.x), std::min(lower.y, middle.y), std::min(lower.z, middle.z)};
    upper = {std::max(upper.x, middle.x), std::max(upper.y, middle.y), std::max(upper.z, middle.z)};
  }
  return {lower, std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z})};
}

/// The triangles that remain when all vertices of a grid square are moved to its first vertex.
std::vector<Corners> movedTogether(std::span<const Vec3> places, std::span<const Corners> corners, const Cube& cube,
                                   double resolution) {
  constexpr double kReach = 1 << 20;
  const auto stepOf = [&](double x, double lower) {
    const double step = std::floor((x / cube.side - lower / cube.side) * resolution);
    return static_cast<std::uint64_t>(std::clamp(step, -kReach, kReach - 1) + kReach);
  };
  std::unordered_map<std::uint64_t, std::uint16_t> firsts;
  std::vector<std::uint16_t> moved;
  moved.reserve(places.size());
  for (const Vec3& p : places) {
    const std::uint64_t key =
        (stepOf(p.x, cube.lower.x) << 42U) | (stepOf(p.y, cube.lower.y) << 21U) | stepOf(p.z, cube.lower.z);
    moved.push_back(firsts.try_emplace(key, static_cast<std::uint16_t>(moved.size())).first->second);
  }
  std::vector<Corners> left;
  std::unordered_set<std::uint64_t> known;
  for (const Corners& triangle : corners) {
    Corners now{moved[triangle[0]], moved[triangle[1]], moved[triangle[2]]};
    if (now[0] == now[1] || now[1] == now[2] || now[2] == now[0]) continue;
    // Walls without thickness have two sides: the order of corners counts, the first corner does not.
    std::rotate(now.begin(), std::min_element(now.begin(), now.end()), now.end());
    if (known.insert(std::uint64_t{now[0]} << 32U | std::uint64_t{now[1]} << 16U | now[2]).second) left.push_back(now);
  }
  return left;
}

/// The result of nearly the finest grid that leaves at most `most` triangles. A grid of twice the resolution leaves
/// about four times as many.
std::vector<Corners> clustered(std::span<const Vec3> places, std::span<const Corners> corners, std::size_t most) {
  constexpr int kTries = 8;
  const Cube cube = cubeOf(places, corners);
  if (!(cube.side > 0) || !std::isfinite(cube.side)) return {corners.begin(), corners.end()};
  double resolution = std::sqrt(static_cast<double>(most));
  std::vector<Corners> left = movedTogether(places, corners, cube, resolution);
  for (int tried = 1; tried < kTries; ++tried) {
    const double share = static_cast<double>(left.size()) / static_cast<double>(most);
    if (share <= 1 && (share > 0.7 || tried > 2)) break;
    resolution *= std::clamp(std::sqrt(0.85 / std::max(share, 1e-3)), 0.3, 3.0);
    left = movedTogether(places, corners, cube, resolution);
  }
  return left;
}

}  // namespace

std::size_t coarseFacesOf(std::uint64_t blocks) {
  return static_cast<std::size_t>(
      std::clamp(kAllCoarse / std::max<std::uint64_t>(blocks, 1), kLeast, kMostCoarseFaces));
}

std::vector<CoarseFace> coarseFaces(std::span<const Vec3> places, std::span<const Corners> corners, std::size_t most) {
  const auto areasOf = [&](std::span<const Corners> triangles) {
    std::vector<double> areas;
    areas.reserve(triangles.size());
    for (const Corners& triangle : triangles) areas.push_back(areaIn(places, triangle));
    return areas;
  };
  std::vector<CoarseFace> result;
  const auto takeLargest = [&](std::span<const Corners> triangles, const std::vector<std::uint32_t>& largest) {
    for (const std::uint32_t t : largest) result.push_back(faceOf(places, triangles[t]));
  };
  const std::vector<double> areas = areasOf(corners);
  const std::vector<std::uint32_t> largest = largestOf(areas, most);
  const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double taken =
      std::accumulate(largest.begin(), largest.end(), 0.0, [&](double sum, std::uint32_t t) { return sum + areas[t]; });
  if (corners.size() <= most || !(taken < kMostOfArea * all)) {
    takeLargest(corners, largest);
    return result;
  }
  const std::vector<Corners> few = clustered(places, corners, most);
  takeLargest(few, largestOf(areasOf(few), most));
  return result;
}

}  // namespace footfall::detail
