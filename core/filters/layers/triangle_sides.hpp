// A triangle in the plan with those across its sides.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/box_tree.hpp"
#include "core/exact/error_double.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// A triangle as pairs of them are compared: its places in the plan and their box.
struct BoxedTriangle {
  Index triangle = -1;  ///< or -1: there is none
  PlanTriangle plan{};
  BoxTree<2>::Bounds bounds{};

  [[nodiscard]] bool isApartFrom(const BoxedTriangle& other) const {
    for (std::size_t k = 0; k < 2; ++k)
      if (bounds.lower[k] > other.bounds.upper[k] || other.bounds.lower[k] > bounds.upper[k]) return true;
    return false;
  }
};

/// The triangle itself, and those across its sides.
using TriangleAndAcross = std::array<BoxedTriangle, 4>;

/// False where side i of one triangle and side j of another certainly do not lie on one line. `slack` is that of the
/// kernel's signs; the bound is that of MeshGeometry::overlap().
inline bool mayLieOnOneLine(const PlanTriangle& s, std::size_t i, const PlanTriangle& t, std::size_t j, double slack) {
  constexpr double kU = 0x1p-53;
  const double x = s.x[i], y = s.y[i], ux = s.x[(i + 1) % 3] - x, uy = s.y[(i + 1) % 3] - y;
  for (const std::size_t end : {j, (j + 1) % 3}) {
    const double vx = t.x[end] - x, vy = t.y[end] - y;
    const double size = std::max({std::fabs(ux), std::fabs(uy), std::fabs(vx), std::fabs(vy)});
    const double f = 2 * std::max(s.error, t.error) + 4 * kU * size;
    const double bound = (8 * size * f + 2 * f * f + 32 * kU * size * size) * kInflate + slack;
    if (std::fabs(ux * vy - uy * vx) > bound) return false;
  }
  return true;
}

}  // namespace footfall::detail
