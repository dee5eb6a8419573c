// Triangles and edges of environments and meshes, from which the view's vertex buffers are made.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/vector.hpp"
#include "core/mesh/adjacency.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

// The limit of creases: edges whose triangles turn by more than about 25 degrees help to read a shape.
inline constexpr double kCreaseCosine = 0.9;

inline std::array<float, 3> toFloats(const Vec3& p, const Vec3& centre) {
  return {static_cast<float>(p.x - centre.x), static_cast<float>(p.y - centre.y), static_cast<float>(p.z - centre.z)};
}

inline Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = normalOf(a, b, c);
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  return length > 0 ? Vec3{n.x / length, n.y / length, n.z / length} : Vec3{0, 0, 1};
}

inline bool isCrease(const Vec3& a, const Vec3& b) {
  return std::abs(a.x * b.x + a.y * b.y + a.z * b.z) < kCreaseCosine;
}

inline std::int8_t toByte(double component) { return static_cast<std::int8_t>(std::lround(component * 127)); }

inline void addTriangle(std::vector<SurfaceVertex>& surface, const std::array<const Vec3*, 3>& corners,
                        const Vec3& centre, const Vec3& normal, const Paint& paint, bool takesFloorPaint) {
  SurfaceVertex vertex;
  vertex.normal = {toByte(normal.x), toByte(normal.y), toByte(normal.z), 0};
  setPaint(vertex, paint);
  if (takesFloorPaint) vertex.colour[3] = 0;
  for (const Vec3* corner : corners) {
    vertex.position = toFloats(*corner, centre);
    surface.push_back(vertex);
  }
}

inline std::array<const Vec3*, 3> cornersOf(const std::vector<Vec3>& vertices, const Triangle& triangle) {
  return {&vertices[triangle[0]], &vertices[triangle[1]], &vertices[triangle[2]]};
}

/// An edge of the triangles: its vertices, the smaller one first, and the triangles at it, ascending.
struct SharedEdge {
  std::uint32_t low = 0, high = 0;
  std::vector<std::uint32_t> triangles;
};

// Calls visit(edge) for each edge with two ends, in the order of their vertices.
template <typename Visit>
void forEachEdge(const std::vector<Triangle>& triangles, std::size_t vertexCount, Visit visit) {
  const TriangleCorners corners(triangles);
  const Adjacency adjacency = findEdges(corners, vertexCount);
  SharedEdge edge;
  for (Index e = 0; e < adjacency.edgeCount(); ++e) {
    const auto sides = adjacency.sidesOf(e);
    const auto [low, high] = std::minmax({corners.beginOf(sides[0]), corners.endOf(sides[0])});
    if (low == high) continue;
    edge.low = static_cast<std::uint32_t>(low);
    edge.high = static_cast<std::uint32_t>(high);
    edge.triangles.clear();
    for (const Index side : sides) edge.triangles.push_back(static_cast<std::uint32_t>(side / 3));
    visit(std::as_const(edge));
  }
}

}  // namespace footfall::ui
