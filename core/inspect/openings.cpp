// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/openings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/base/triangle_tree.hpp"
#include "core/base/vector.hpp"

namespace footfall::detail {
namespace {

constexpr double kWidest = 1.0 / 3, kLongest = 2;  // of a lintel, by the free height under it

std::array<Vec3, 3> cornersOf(const Environment& environment, std::size_t t) {
  const Triangle& f = environment.triangles[t];
  return {environment.vertices[f[0]], environment.vertices[f[1]], environment.vertices[f[2]]};
}

/// The underside of something long, by its shape alone.
struct Lintel {
  Vec3 middle;
  double length = 0, width = 0;
};

std::optional<Lintel> lintelOf(const std::array<Vec3, 3>& p) {
  if (p[0].z != p[1].z || p[0].z != p[2].z) return std::nullopt;
  const double area = normalOf(p[0], p[1], p[2]).z;
  if (!(area < 0)) return std::nullopt;
  std::array<double, 3> sides{length(p[1] - p[0]), length(p[2] - p[1]), length(p[0] - p[2])};
  std::sort(sides.begin(), sides.end());
  // Half a rectangle: the second side is its length.
  const double width = -area / sides[1];
  if (!(width < sides[1])) return std::nullopt;
  return Lintel{(p[0] + p[1] + p[2]) * (1.0 / 3), sides[1], width};
}

/// The height of a triangle at a place of the plan, where it is there.
std::optional<double> heightAt(const std::array<Vec3, 3>& p, const Vec3& at) {
  const Vec3 n = normalOf(p[0], p[1], p[2]);
  if (n.z == 0) return std::nullopt;
  const double sign = n.z > 0 ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = p[k], &b = p[(k + 1) % 3];
    if (sign * ((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) < 0) return std::nullopt;
  }
  return p[0].z - (n.x * (at.x - p[0].x) + n.y * (at.y - p[0].y)) / n.z;
}

}  // namespace

std::vector<double> measureOpenings(const Environment& environment, const Poll& poll) {
  constexpr std::size_t kPollEvery = 4096;
  std::vector<Lintel> lintels;
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    if (t % kPollEvery == 0) poll();
    if (const auto lintel = lintelOf(cornersOf(environment, t))) lintels.push_back(*lintel);
  }
  std::vector<double> heights;
  if (lintels.empty()) return heights;
  std::vector<Box> boxes(environment.triangles.size());
  std::vector<std::int32_t> ids(boxes.size());
  double lowest = lintels.front().middle.z;
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    if (t % kPollEvery == 0) poll();
    const auto [a, b, c] = cornersOf(environment, t);
    boxes[t] = {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
    lowest = std::min(lowest, boxes[t].lower[2]);
    ids[t] = static_cast<std::int32_t>(t);
  }
  TriangleTree tree;
  tree.build(boxes, ids, poll);
  std::vector<std::int32_t> stack;
  for (const Lintel& lintel : lintels) {
    poll();
    const Vec3& at = lintel.middle;
    std::optional<double> floor;
    tree.visitOverlapping(Box{{at.x, at.y, lowest}, {at.x, at.y, at.z}}, stack, [&](std::int32_t t) {
      const auto z = heightAt(cornersOf(environment, static_cast<std::size_t>(t)), at);
      if (z && *z < at.z && (!floor || *z > *floor)) floor = z;
      return true;
    });
    if (!floor) continue;
    const double height = at.z - *floor;
    if (lintel.width <= kWidest * height && lintel.length <= kLongest * height) heights.push_back(height);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

}  // namespace footfall::detail
