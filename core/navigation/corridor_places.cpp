// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/corridor_places.hpp"

#include <cmath>

namespace footfall::detail {

std::vector<Vec3> placesAlong(const CorridorMap& map, const CorridorEdge& edge) {
  const Vec3 &a = map.vertices[edge.from].place, &b = map.vertices[edge.to].place;
  if (edge.shape == CorridorShape::Straight) return {a, b};
  constexpr int kPieces = 8;
  const bool isLeftCorner = edge.left[0] == edge.left[1];
  const Vec3& focus = isLeftCorner ? edge.left[0] : edge.right[0];
  const auto& line = isLeftCorner ? edge.right : edge.left;
  std::vector<Vec3> places{a};
  const double x = line[1].x - line[0].x, y = line[1].y - line[0].y, length = std::hypot(x, y);
  for (int i = 1; i < kPieces && length > 0; ++i) {
    const double share = static_cast<double>(i) / kPieces;
    const Vec3 foot{line[0].x + share * x, line[0].y + share * y, 0};
    // The place is as far from the foot, at a right angle to the line, as from the focus.
    const double nx = isLeftCorner ? -y / length : y / length, ny = isLeftCorner ? x / length : -x / length;
    const double dx = focus.x - foot.x, dy = focus.y - foot.y, across = dx * nx + dy * ny;
    if (!(across > 0)) continue;
    const double t = (dx * dx + dy * dy) / (2 * across);
    places.push_back({foot.x + t * nx, foot.y + t * ny, a.z + share * (b.z - a.z)});
  }
  places.push_back(b);
  return places;
}

}  // namespace footfall::detail
