// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/packed/packer_polygons.hpp"

#include <algorithm>
#include <cstddef>

namespace footfall::detail {

bool triangulatePolygon(std::span<const std::uint32_t> corners, const PackerVertices& vertices,
                        std::vector<Triangle>& triangles, const Poll& poll) {
  std::vector<std::uint32_t> numbers(corners.begin(), corners.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<Vec3> places;
  for (const std::uint32_t number : numbers) places.push_back(vertices.sink.vertex(number));
  std::vector<std::uint32_t> local;
  for (const std::uint32_t corner : corners)
    local.push_back(
        static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), corner) - numbers.begin()));
  const std::size_t first = triangles.size();
  if (!detail::triangulatePolygon(local, places, triangles, poll)) return false;
  for (std::size_t t = first; t < triangles.size(); ++t)
    for (std::uint32_t& corner : triangles[t]) corner = numbers[corner];
  return true;
}

SkippedPolygon skippedPolygon(std::span<const std::uint32_t> corners, const PackerVertices& vertices) {
  std::vector<Vec3> places;
  std::vector<std::uint32_t> local, numbers;
  for (const std::uint32_t corner : corners) {
    const auto known = std::find(numbers.begin(), numbers.end(), corner);
    local.push_back(static_cast<std::uint32_t>(known - numbers.begin()));
    if (known != numbers.end()) continue;
    numbers.push_back(corner);
    places.push_back(vertices.sink.vertex(corner));
  }
  return detail::skippedPolygon(local, places);
}

}  // namespace footfall::detail
