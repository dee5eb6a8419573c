// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/headroom.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/base/vector.hpp"
#include "core/exact/error_double.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPlacesPerRange = 512;

/// The distance by which rounding may have moved a coordinate: a few operations of half a unit in the last place each.
constexpr double kRounding = 8 * 0x1p-53;

Vec3 difference(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

bool covers(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = a.x * b.y - a.y * b.x, bc = b.x * c.y - b.y * c.x, ca = c.x * a.y - c.y * a.x;
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// The height of a triangle's plane above a place that may be off by its rounding.
ErrorDouble heightAbove(const std::array<Vec3, 3>& corners, const Vec3& place) {
  std::array<ErrorDouble, 3> x, y, z;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = ErrorDouble(corners[k].x) - ErrorDouble(place.x, std::fabs(place.x) * kRounding);
    y[k] = ErrorDouble(corners[k].y) - ErrorDouble(place.y, std::fabs(place.y) * kRounding);
    z[k] = ErrorDouble(corners[k].z) - ErrorDouble(place.z, std::fabs(place.z) * kRounding);
  }
  // The normal, from differences of corners, which rounding does not touch.
  std::array<ErrorDouble, 3> u, v;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 &from = corners[0], &to = corners[k + 1];
    auto& side = k == 0 ? u : v;
    side = {ErrorDouble(to.x) - ErrorDouble(from.x), ErrorDouble(to.y) - ErrorDouble(from.y),
            ErrorDouble(to.z) - ErrorDouble(from.z)};
  }
  const auto [nx, ny, nz] = cross(u, v);
  return z[0] + (nx * x[0] + ny * y[0]) / nz;
}

}  // namespace

HeadroomTree::HeadroomTree(std::shared_ptr<const Environment> environment, Poll poll)
    : environment_(std::move(environment)) {
  const auto& vertices = environment_->vertices;
  const auto& triangles = environment_->triangles;
  std::vector<char> counts(triangles.size());
  forRanges(triangles.size(), 8192, [&](std::size_t first, std::size_t last) {
    poll();
    for (std::size_t t = first; t < last; ++t) {
      const auto& [a, b, c] = triangles[t];
      counts[t] = static_cast<char>(facing(vertices[a], vertices[b], vertices[c]) != 0);
    }
  });
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (counts[t] == 0) continue;
    const Vec3 &a = vertices[triangles[t][0]], &b = vertices[triangles[t][1]], &c = vertices[triangles[t][2]];
    boxes.push_back({{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                     {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
    ids.push_back(static_cast<std::int32_t>(t));
  }
  tree_.build(boxes, ids, poll);
}

std::optional<HeadroomTree::Above> HeadroomTree::lowestAbove(const Vec3& place, double cap,
                                                             std::vector<std::int32_t>& stack) const {
  std::optional<Above> lowest;
  const Box query{{place.x, place.y, place.z}, {place.x, place.y, place.z + cap}};
  tree_.visitOverlapping(query, stack, [&](std::int32_t id) {
    const auto& triangle = environment_->triangles[static_cast<std::size_t>(id)];
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = environment_->vertices[triangle[k]];
    if (!covers(difference(corners[0], place), difference(corners[1], place), difference(corners[2], place)))
      return true;
    const ErrorDouble height = heightAbove(corners, place);
    if (!(height.value > height.error && height.value < cap)) return true;
    const auto number = static_cast<std::uint32_t>(id);
    if (!lowest || height.value < lowest->height || (height.value == lowest->height && number < lowest->triangle))
      lowest = Above{height.value, number};
    return true;
  });
  return lowest;
}

std::vector<float> headroomAt(const HeadroomTree& tree, std::span<const Vec3> places, double cap, Poll poll) {
  std::vector<float> heights(places.size());
  forRanges(places.size(), kPlacesPerRange, [&](std::size_t first, std::size_t last) {
    poll();
    std::vector<std::int32_t> stack;
    for (std::size_t i = first; i < last; ++i) {
      const auto above = tree.lowestAbove(places[i], cap, stack);
      heights[i] = static_cast<float>(above ? above->height : cap);
    }
  });
  return heights;
}

}  // namespace footfall::detail
