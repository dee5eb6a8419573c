// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/convex_triangulation.hpp"

#include <limits>

namespace footfall::detail {

std::size_t ConvexTriangulation::fanApex() const {
  std::size_t corners = 0, apex = outline_.size();
  for (std::size_t k = 0; k < outline_.size(); ++k) {
    if (!outline_[k].isCorner) continue;
    ++corners;
    if (outline_[turned(k, 1)].isCorner && outline_[turned(k, outline_.size() - 1)].isCorner) apex = k;
  }
  return corners == 3 ? apex : outline_.size();
}

std::size_t ConvexTriangulation::bestCorner() const {
  std::size_t best = outline_.size();
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline_.size(); ++k) {
    if (!outline_[k].isCorner) continue;
    const Vec3 &p = places_[outline_[turned(k, outline_.size() - 1)].vertex],
               &q = places_[outline_[turned(k, 1)].vertex];
    const double x = q.x - p.x, y = q.y - p.y, z = q.z - p.z;
    const double length = x * x + y * y + z * z;
    if (best != outline_.size() && !(length < shortest)) continue;
    best = k;
    shortest = length;
  }
  return best;
}

}  // namespace footfall::detail
