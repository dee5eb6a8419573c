// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/path_figures.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"
#include "core/navigation/plan_distance.hpp"

namespace footfall::detail {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

double slopeDegrees(const NavigationMesh& mesh, std::uint32_t t) {
  const Triangle& f = mesh.triangles[t];
  const Vec3 n = normalOf(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]);
  return std::atan2(std::hypot(n.x, n.y), n.z) * kDegrees;
}

}  // namespace

void addFigures(const NavigationMesh& mesh, PathResult& result) {
  // Measured along straight pieces, so that crossings, which are rounded, add nothing.
  std::vector<std::size_t> corners = result.bends;
  corners.push_back(result.points.size() - 1);
  std::size_t last = 0;
  for (const std::size_t corner : corners) {
    result.planLength += planDistance(result.points[last], result.points[corner]);
    last = corner;
  }
  for (std::size_t i = 0; i < result.triangles.size(); ++i) {
    const Vec3 &a = result.points[i], &b = result.points[i + 1];
    const std::uint32_t t = result.triangles[i];
    const double plan = planDistance(a, b);
    result.length += std::hypot(plan, b.z - a.z);
    const double rise = b.z - a.z;
    (rise > 0 ? result.climb : result.descent) += std::fabs(rise);
    if (!mesh.layers.empty() && (result.layers.empty() || result.layers.back() != mesh.layers[t]))
      result.layers.push_back(mesh.layers[t]);
    if (std::binary_search(result.steps.begin(), result.steps.end(), i) ||
        std::binary_search(result.gaps.begin(), result.gaps.end(), i))
      continue;
    const double slope = slopeDegrees(mesh, t);
    result.maxSlopeDegrees = std::max(result.maxSlopeDegrees, slope);
    // The rounded direction of pieces of a few units in the last place is meaningless: no piece is steeper than its
    // triangle.
    result.maxInclineDegrees =
        std::max(result.maxInclineDegrees, std::min(slope, std::atan2(std::fabs(rise), plan) * kDegrees));
  }
  if (result.triangles.empty() && !mesh.layers.empty()) result.layers = {mesh.layers[result.start->triangle]};
  result.connections = result.layers.empty() ? 0 : result.layers.size() - 1;
}

void joinGaps(std::uint32_t triangleCount, PathResult& result) {
  const PathResult traced = result;
  const auto isBridge = [&](std::size_t piece) { return traced.triangles[piece] >= triangleCount; };
  const std::size_t pieces = traced.triangles.size();
  result.points = {traced.points.front()};
  result.triangles.clear();
  result.bends.clear();
  result.steps.clear();
  for (std::size_t i = 0; i < pieces; ++i) {
    const bool bends = std::binary_search(traced.bends.begin(), traced.bends.end(), i + 1);
    if (isBridge(i) && i + 1 < pieces && isBridge(i + 1) && !bends) continue;
    if (isBridge(i)) result.gaps.push_back(result.triangles.size());
    if (std::binary_search(traced.steps.begin(), traced.steps.end(), i))
      result.steps.push_back(result.triangles.size());
    std::size_t arrival = i;
    while (arrival + 1 < pieces && isBridge(arrival)) ++arrival;
    result.triangles.push_back(isBridge(arrival) ? result.end->triangle : traced.triangles[arrival]);
    result.points.push_back(traced.points[i + 1]);
    if (bends) result.bends.push_back(result.points.size() - 1);
  }
}

}  // namespace footfall::detail
