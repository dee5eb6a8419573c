// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/preview_borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/mesh/adjacency.hpp"

namespace footfall::ui {

std::vector<PreviewBorder> findBorders(const NavigationMesh& mesh, Poll poll) {
  using Ends = std::array<std::uint32_t, 2>;
  std::vector<Ends> linked;
  for (const StepLink& link : mesh.links) {
    linked.push_back(link.from);
    linked.push_back(link.to);
  }
  std::sort(linked.begin(), linked.end());
  const Adjacency edges = findEdges(mesh.triangles, mesh.vertices.size(), poll);
  std::vector<PreviewBorder> borders;
  for (Index e = 0; e < edges.edgeCount(); ++e) {
    if (e % 4096 == 0) poll();
    const auto sides = edges.sidesOf(e);
    if (sides.size() != 1) continue;
    const Triangle& triangle = mesh.triangles[static_cast<std::size_t>(sides[0] / 3)];
    const auto corner = static_cast<std::size_t>(sides[0] % 3);
    const Ends ends{triangle[corner], triangle[(corner + 1) % 3]};
    if (std::binary_search(linked.begin(), linked.end(), ends)) continue;
    PreviewBorder border{mesh.vertices[ends[0]], mesh.vertices[ends[1]], {}, {}, 0};
    const double x = border.to.x - border.from.x, y = border.to.y - border.from.y;
    border.size = std::hypot(x, y);
    if (!(border.size > 0)) continue;
    border.along = {x / border.size, y / border.size, 0};
    border.inward = {-border.along.y, border.along.x, 0};
    borders.push_back(border);
  }
  return borders;
}

Box boxAround(const std::vector<Vec3>& points, double sideways, double upright) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  for (const Vec3& p : points) {
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const double room = k < 2 ? sideways : upright;
      box.lower[k] = std::min(box.lower[k], at[k] - room);
      box.upper[k] = std::max(box.upper[k], at[k] + room);
    }
  }
  return box;
}

}  // namespace footfall::ui
