// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/link_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/vector.hpp"
#include "ui/view/geometry/surface_triangles.hpp"

namespace footfall::ui {
namespace {

// Four lines for each link, like a rung between two rails.
void addSteps(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry) {
  for (const StepLink& link : mesh.links) {
    if (link.kind != StepKind::Step) continue;
    for (const auto& [a, b] :
         std::array{link.from, link.to, std::array{link.from[0], link.to[1]}, std::array{link.from[1], link.to[0]}}) {
      geometry.steps.push_back({toFloats(mesh.vertices[a], centre), toFloats(mesh.vertices[b], centre)});
      if (!mesh.layers.empty())
        geometry.stepLayers.push_back({mesh.layers[link.fromTriangle], mesh.layers[link.toTriangle]});
    }
  }
}

// Draws both edges of a gap as dashes, and its ends, so that gaps differ from steps in more than colour.
void addGaps(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry) {
  constexpr double kDashOfWidth = 4, kMostDashes = 24;
  for (const StepLink& link : mesh.links) {
    if (link.kind != StepKind::Gap) continue;
    const std::array<Vec3, 2> first{mesh.vertices[link.from[0]], mesh.vertices[link.from[1]]};
    const std::array<Vec3, 2> second{mesh.vertices[link.to[1]], mesh.vertices[link.to[0]]};
    const double size = length(first[1] - first[0]);
    const auto dashes = static_cast<int>(std::clamp(size / (2 * kDashOfWidth * link.width), 2.0, kMostDashes));
    const auto add = [&](const Vec3& a, const Vec3& b) {
      geometry.gaps.push_back({toFloats(a, centre), toFloats(b, centre)});
      if (!mesh.layers.empty())
        geometry.gapLayers.push_back({mesh.layers[link.fromTriangle], mesh.layers[link.toTriangle]});
    };
    for (const auto& [a, b] : {first, second})
      for (int i = 0; i < dashes; ++i) {
        const double begin = 2.0 * i / (2 * dashes - 1), end = (2.0 * i + 1) / (2 * dashes - 1);
        add(a + begin * (b - a), a + end * (b - a));
      }
    add(first[0], second[0]);
    add(first[1], second[1]);
  }
}

Vec3 between(const Vec3& a, const Vec3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

// Draws the border of a drop, and a few arrows whose distance is the depth of the drop.
void addDropLines(const DropLink& drop, const Vec3& centre, std::vector<LineSegment>& lines) {
  constexpr double kMostArrows = 8, kHead = 0.25, kHeadWidth = 0.35;
  const auto add = [&](const Vec3& a, const Vec3& b) { lines.push_back({toFloats(a, centre), toFloats(b, centre)}); };
  add(drop.start[0], drop.start[1]);
  const double arrows = std::clamp(std::round(drop.width / std::max(drop.depth, 1e-300)), 1.0, kMostArrows);
  // Half the width of a head, as a share of the border: the head stays inside, and is no wider than the drop is deep.
  const double half = std::min(0.4 / arrows, kHead * kHeadWidth * drop.depth / std::max(drop.width, 1e-300));
  for (double i = 0; i < arrows; ++i) {
    const double t = (i + 0.5) / arrows;
    const Vec3 tip = between(drop.landing[0], drop.landing[1], t);
    add(between(drop.start[0], drop.start[1], t), tip);
    for (const double side : {t - half, t + half})
      add(between(between(drop.landing[0], drop.landing[1], side), between(drop.start[0], drop.start[1], side), kHead),
          tip);
  }
}

void addDrops(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry) {
  for (const DropLink& drop : mesh.drops) {
    addDropLines(drop, centre, geometry.drops);
    if (!mesh.layers.empty())
      geometry.dropLayers.resize(geometry.drops.size(), {mesh.layers[drop.fromTriangle], mesh.layers[drop.toTriangle]});
  }
}

}  // namespace

void addLinkLines(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry) {
  addSteps(mesh, centre, geometry);
  addGaps(mesh, centre, geometry);
  addDrops(mesh, centre, geometry);
}

}  // namespace footfall::ui
