// Boxes in the plan of triangles, of their sides, and of parts of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/box_tree.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

inline constexpr Index kMostParts = 64;

inline BoxTree<2>::Bounds planBoundsOf(const PlanTriangle& p) {
  return {{std::min({p.x[0], p.x[1], p.x[2]}) - p.error, std::min({p.y[0], p.y[1], p.y[2]}) - p.error},
          {std::max({p.x[0], p.x[1], p.x[2]}) + p.error, std::max({p.y[0], p.y[1], p.y[2]}) + p.error}};
}

inline BoxTree<2>::Bounds boundsOfSide(const PlanTriangle& p, std::size_t side) {
  const std::size_t a = side, b = (a + 1) % 3;
  return {{std::min(p.x[a], p.x[b]) - p.error, std::min(p.y[a], p.y[b]) - p.error},
          {std::max(p.x[a], p.x[b]) + p.error, std::max(p.y[a], p.y[b]) + p.error}};
}

/// The number of parts into which a triangle is cut; this number reduces how many of them reach a place, compared with
/// whole boxes.
inline Index partCount(const PlanTriangle& p) {
  const BoxTree<2>::Bounds b = planBoundsOf(p);
  const double area = std::fabs((p.x[1] - p.x[0]) * (p.y[2] - p.y[0]) - (p.x[2] - p.x[0]) * (p.y[1] - p.y[0]));
  const double wasted = (b.upper[0] - b.lower[0]) * (b.upper[1] - b.lower[1]) / area / 4;
  if (!(wasted >= 2)) return 1;
  return wasted < kMostParts ? static_cast<Index>(wasted) : kMostParts;
}

/// The box of the part between two places along the longer side of the box. Rounded corners are off by the error, so
/// each point of the triangle is that near to one of the rounded triangle, which is cut a little before and behind both
/// places.
inline BoxTree<2>::Bounds boundsOfPart(const PlanTriangle& p, Index number, Index count) {
  BoxTree<2>::Bounds bounds = planBoundsOf(p);
  if (count == 1) return bounds;
  const std::array<double, 2> size{bounds.upper[0] - bounds.lower[0], bounds.upper[1] - bounds.lower[1]};
  const int axis = size[0] >= size[1] ? 0 : 1;
  const auto &along = axis == 0 ? p.x : p.y, &across = axis == 0 ? p.y : p.x;
  const double step = size[axis] / count, start = bounds.lower[axis], margin = step / 64 + 4 * p.error;
  if (number > 0) bounds.lower[axis] = start + number * step - margin;
  if (number + 1 < count) bounds.upper[axis] = start + (number + 1) * step + margin;
  const double low = bounds.lower[axis] - margin, high = bounds.upper[axis] + margin;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  const auto take = [&](double place) {
    least = std::min(least, place);
    most = std::max(most, place);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    if (along[k] >= low && along[k] <= high) take(across[k]);
    for (const double end : {low, high})
      if (std::min(along[k], along[n]) < end && end < std::max(along[k], along[n]))
        take(across[k] + (end - along[k]) / (along[n] - along[k]) * (across[n] - across[k]));
  }
  const double slack = p.error + (std::fabs(least) + std::fabs(most)) * 0x1p-48;
  bounds.lower[1 - axis] = std::max(bounds.lower[1 - axis], least - slack);
  bounds.upper[1 - axis] = std::min(bounds.upper[1 - axis], most + slack);
  return bounds;
}

}  // namespace footfall::detail
