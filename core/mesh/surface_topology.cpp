// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_topology.hpp"

#include <cstddef>

#include "core/base/disjoint_sets.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/mesh/adjacency.hpp"

namespace footfall::detail {
namespace {

Index sideFrom(const Triangle& t, std::uint32_t vertex) { return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2; }

}  // namespace

SurfaceTopology makeSurfaceTopology(const NavigationMesh& mesh, Poll poll) {
  const std::size_t count = mesh.triangles.size();
  SurfaceTopology topology;
  topology.neighbours.assign(count, {kNoElement, kNoElement, kNoElement});
  topology.fans.assign(count, {kNoElement, kNoElement, kNoElement});
  topology.components.assign(count, kNoElement);

  std::vector<char> takesPart(count, 0);
  for (std::size_t t = 0; t < count; ++t) {
    if (t % 4096 == 0) poll();
    const Triangle& f = mesh.triangles[t];
    takesPart[t] = static_cast<char>(facing(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]) > 0);
  }
  const TriangleCorners triangles(mesh.triangles);
  const Adjacency adjacency = findEdges(triangles, mesh.vertices.size(), poll);
  poll();
  DisjointSets corners(3 * count), parts(count);
  std::vector<Index> sides;
  for (Index e = 0; e < adjacency.edgeCount(); ++e) {
    sides.clear();
    for (const Index side : adjacency.sidesOf(e))
      if (takesPart[side / 3] != 0) sides.push_back(side);
    if (sides.size() != 2 || triangles.beginOf(sides[0]) == triangles.beginOf(sides[1])) continue;
    const Index a = sides[0] / 3, i = sides[0] % 3, b = sides[1] / 3, j = sides[1] % 3;
    topology.neighbours[a][i] = static_cast<std::uint32_t>(b);
    topology.neighbours[b][j] = static_cast<std::uint32_t>(a);
    corners.unite(3 * a + i, 3 * b + (j + 1) % 3);
    corners.unite(3 * a + (i + 1) % 3, 3 * b + j);
    parts.unite(a, b);
  }
  for (const StepLink& link : mesh.links) {
    const auto a = static_cast<Index>(link.fromTriangle), b = static_cast<Index>(link.toTriangle);
    if (takesPart[a] == 0 || takesPart[b] == 0) continue;
    const Index i = sideFrom(mesh.triangles[a], link.from[0]), j = sideFrom(mesh.triangles[b], link.to[0]);
    const auto samePlace = [&](std::uint32_t v, std::uint32_t w) {
      return mesh.vertices[v].x == mesh.vertices[w].x && mesh.vertices[v].y == mesh.vertices[w].y;
    };
    if (topology.neighbours[a][i] != kNoElement || topology.neighbours[b][j] != kNoElement ||
        !samePlace(link.from[0], link.to[1]) || !samePlace(link.from[1], link.to[0]))
      continue;
    topology.neighbours[a][i] = static_cast<std::uint32_t>(b);
    topology.neighbours[b][j] = static_cast<std::uint32_t>(a);
    corners.unite(3 * a + i, 3 * b + (j + 1) % 3);
    corners.unite(3 * a + (i + 1) % 3, 3 * b + j);
    parts.unite(a, b);
  }
  poll();

  for (std::uint32_t t = 0; t < count; ++t) {
    if (takesPart[t] == 0) continue;
    const auto first = static_cast<std::uint32_t>(parts.find(static_cast<Index>(t)));
    topology.components[t] = first == t ? topology.componentCount++ : topology.components[first];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto representative = static_cast<std::uint32_t>(corners.find(static_cast<Index>(3 * t + i)));
      if (representative == 3 * t + i) {
        topology.fans[t][i] = static_cast<std::uint32_t>(topology.fanVertices.size());
        topology.fanVertices.push_back(mesh.triangles[t][i]);
        topology.isOpen.push_back(0);
      } else {
        topology.fans[t][i] = topology.fans[representative / 3][representative % 3];
      }
      if (topology.neighbours[t][i] == kNoElement || topology.neighbours[t][(i + 2) % 3] == kNoElement)
        topology.isOpen[topology.fans[t][i]] = 1;
    }
  }
  return topology;
}

}  // namespace footfall::detail
