// Soups that are compared as meshes, and the expected comparison of equal ones.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "footfall/compare.hpp"
#include "tests/support/soup.hpp"

namespace footfall::test {

constexpr double kTiny = 1e-13;  // relative, of areas

inline NavigationMesh meshOf(const Soup& soup) {
  const auto environment = soup.environment();
  NavigationMesh mesh;
  mesh.vertices = environment->vertices;
  mesh.triangles = environment->triangles;
  return mesh;
}

inline MeshComparison compare(const NavigationMesh& a, const NavigationMesh& b,
                              std::optional<double> height = std::nullopt, std::optional<double> error = std::nullopt) {
  RunContext context;
  return compareMeshes(a, b, {height, error}, &context);
}

inline MeshComparison compare(const Soup& a, const Soup& b, std::optional<double> height = std::nullopt,
                              std::optional<double> error = std::nullopt) {
  return compare(meshOf(a), meshOf(b), height, error);
}

inline bool isNear(double a, double b, double relative = kTiny) {
  return std::fabs(a - b) <= relative * std::max(std::fabs(a), std::fabs(b));
}

/// Everything that must be exactly nothing between equal sets.
inline bool isEqualInAll(const MeshComparison& c) {
  bool none = c.equal() && c.covered() == 1;
  for (const std::size_t side : {0, 1}) {
    none = none && c.sets.areas[side].surface == 0 && c.meshes[side].whole.uncovered.surface == 0;
    if (!c.distances) continue;
    const auto& d = c.distances->at(side);
    none = none && d.min == 0 && d.max == 0 && d.mean == 0 && d.rms == 0 && d.lower == 0 && d.upper == 0;
  }
  return none;
}

using Corners = std::array<Vec3, 3>;

inline Vec3 mix(const Vec3& a, const Vec3& b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
}

}  // namespace footfall::test
