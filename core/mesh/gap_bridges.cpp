// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/gap_bridges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

bool isSamePlace(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y; }

/// True when both edges of a link end at one place, at the given end.
bool meetsAt(const StepLink& link, std::span<const Vec3> vertices, int end) {
  return isSamePlace(vertices[link.from[end]], vertices[link.to[1 - end]]);
}

}  // namespace

std::vector<Triangle> bridgeOver(const StepLink& link, std::span<const Vec3> vertices) {
  const auto [a, b] = link.from;
  const auto [c, d] = link.to;
  const auto isUp = [&](const Triangle& t) { return facing(vertices[t[0]], vertices[t[1]], vertices[t[2]]) > 0; };
  std::vector<Triangle> bridge;
  if (meetsAt(link, vertices, 0) && meetsAt(link, vertices, 1)) return bridge;
  if (meetsAt(link, vertices, 0))
    bridge = {{b, a, c}};
  else if (meetsAt(link, vertices, 1))
    bridge = {{b, a, d}};
  else
    bridge = {{b, a, d}, {b, d, c}};
  if (!std::all_of(bridge.begin(), bridge.end(), isUp)) bridge.clear();
  return bridge;
}

double widthOf(const StepLink& link, std::span<const Vec3> vertices) {
  double width = 0;
  for (const int end : {0, 1}) {
    const Vec3 &p = vertices[link.from[end]], &q = vertices[link.to[1 - end]];
    if (isSamePlace(p, q)) continue;
    // Differences, squares and root are off by a few units in the last place at most.
    const double length = std::hypot(p.x - q.x, p.y - q.y) * (1 + 0x1p-48);
    width = std::max(width, std::nextafter(length, std::numeric_limits<double>::infinity()));
  }
  return width;
}

NavigationMesh withBridges(const NavigationMesh& mesh) {
  NavigationMesh bridged = mesh;
  using Edge = std::array<std::uint32_t, 2>;
  std::set<Edge> taken;
  for (const StepLink& link : mesh.links)
    if (link.kind == StepKind::Step) taken.insert({link.from, link.to});
  for (const StepLink& link : mesh.links) {
    if (link.kind != StepKind::Gap || taken.contains(link.from) || taken.contains(link.to)) continue;
    const std::vector<Triangle> bridge = bridgeOver(link, mesh.vertices);
    if (bridge.empty()) continue;
    taken.insert({link.from, link.to});
    const auto first = static_cast<std::uint32_t>(bridged.triangles.size());
    for (const Triangle& triangle : bridge) {
      bridged.triangles.push_back(triangle);
      bridged.sourceTriangles.push_back(mesh.sourceTriangles.empty() ? 0 : mesh.sourceTriangles[link.fromTriangle]);
      if (!mesh.layers.empty()) bridged.layers.push_back(mesh.layers[link.fromTriangle]);
    }
    const auto addStep = [&](const Edge& from) {
      if (from[0] == link.to[1] && from[1] == link.to[0]) return;
      bridged.links.push_back({from, link.to, first, link.toTriangle, link.height});
    };
    if (meetsAt(link, mesh.vertices, 0)) addStep({link.from[0], link.to[0]});
    if (meetsAt(link, mesh.vertices, 1)) addStep({link.to[1], link.from[1]});
  }
  return bridged;
}

}  // namespace footfall::detail
