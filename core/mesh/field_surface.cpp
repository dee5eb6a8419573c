// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/field_surface.hpp"

#include <algorithm>
#include <limits>

namespace footfall::detail {
namespace {

void placeInPlan(const NavigationMesh& mesh, FieldSurface& surface) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  FieldVector lower{kInfinity, kInfinity}, upper{-kInfinity, -kInfinity};
  for (const Vec3& p : mesh.vertices) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
  }
  surface.places.reserve(mesh.vertices.size());
  if (mesh.vertices.empty()) return;
  surface.origin = lower + (upper - lower) * 0.5;
  surface.scale = std::max({upper.x - lower.x, upper.y - lower.y, std::numeric_limits<double>::min()});
  for (const Vec3& p : mesh.vertices) surface.places.push_back(FieldVector{p.x, p.y} - surface.origin);
}

}  // namespace

std::vector<FieldCorner> fanFrom(const FieldSurface& surface, std::uint32_t face, int side) {
  std::vector<FieldCorner> fan{{face, side}};
  for (;;) {
    const auto [f, i] = fan.back();
    const int behind = (i + 2) % 3;
    const FieldEdge& edge = surface.edgeOf(f, behind);
    if (edge.isBorder()) return fan;
    const int other = (surface.halves[f][behind] & 1) != 0 ? 0 : 1;
    fan.push_back({edge.faces[other], edge.sides[other]});
  }
}

FieldSurface makeFieldSurface(const NavigationMesh& bridged, Poll poll) {
  constexpr std::uint32_t kNone = FieldEdge::kNone;
  FieldSurface surface;
  surface.topology = makeSurfaceTopology(bridged, poll);
  surface.faces = bridged.triangles;
  placeInPlan(bridged, surface);
  surface.halves.assign(surface.faces.size(), {kNone, kNone, kNone});
  surface.edges.reserve(2 * surface.faces.size());
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    if (f % 4096 == 0) poll();
    if (surface.topology.components[f] == SurfaceTopology::kNone) continue;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t other = surface.topology.neighbours[f][i];
      const int behind = other == SurfaceTopology::kNone ? 0 : surface.topology.sideBehind(f, i);
      if (other != SurfaceTopology::kNone && surface.halves[other][behind] != kNone) {
        FieldEdge& edge = surface.edges[surface.halves[other][behind] >> 1];
        edge.faces[1] = f;
        edge.sides[1] = static_cast<std::uint8_t>(i);
        surface.halves[f][i] = surface.halves[other][behind] | 1;
        continue;
      }
      FieldEdge edge;
      edge.begin = surface.corner(f, i);
      const FieldVector way = surface.corner(f, i + 1) - edge.begin;
      edge.length = lengthOf(way);
      edge.along = edge.length > 0 ? way * (1 / edge.length) : FieldVector{1, 0};
      edge.faces[0] = f;
      edge.sides[0] = static_cast<std::uint8_t>(i);
      surface.halves[f][i] = static_cast<std::uint32_t>(2 * surface.edges.size());
      surface.edges.push_back(edge);
    }
  }
  return surface;
}

}  // namespace footfall::detail
