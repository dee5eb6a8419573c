// Borders of a run's mesh with exact places, for tests of links.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/assembly/mesh_assembly.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "tests/reference/gaps.hpp"
#include "tests/support/run_filters.hpp"

namespace footfall::test {

using reference::BorderEdge3;
using reference::Point3;
using reference::Rational;

/// A run's mesh with exact places.
struct ExactBorders {
  std::vector<Point3> places;
  std::vector<BorderEdge3> borders;
  std::vector<Index> parts;  ///< parts of the borders: those that hang together over edges and links
  std::vector<std::array<BorderEdge3, 2>> gaps;

  explicit ExactBorders(const StatePtr& state) {
    const WalkableMesh& mesh = *state->mesh;
    for (const MeshVertex& v : mesh.vertices) {
      const auto p = state->kernel->exactPosition(v.point, v.face);
      places.push_back({p[0], p[1], p[2]});
    }
    const auto edgeOf = [&](const std::array<Index, 2>& edge) { return BorderEdge3{places[edge[0]], places[edge[1]]}; };
    const auto topology = topologyOf(*state);
    const TriangleCorners corners(mesh.triangles);
    DisjointSets sets(mesh.triangles.size());
    std::map<std::array<Index, 2>, Index> triangleAt;  // number of each border
    for (Index e = 0; e < topology->edgeCount(); ++e) {
      const auto sides = topology->sidesOf(e);
      if (sides.size() > 1 && !isObstacle(mesh.triangles, sides)) {
        for (const Index side : sides) sets.unite(side / 3, sides[0] / 3);
        continue;
      }
      for (const Index side : sides) {
        const std::array<Index, 2> ends{corners.beginOf(side), corners.endOf(side)};
        borders.push_back(edgeOf(ends));
        parts.push_back(side / 3);
        triangleAt[ends] = side / 3;
      }
    }
    for (const MeshLink& link : mesh.links) {
      sets.unite(triangleAt.at(link.from), triangleAt.at(link.to));
      if (link.isGap) gaps.push_back({edgeOf(link.from), edgeOf(link.to)});
    }
    for (Index& part : parts) part = sets.find(part);
  }

  /// The part of a border that links may have divided since.
  [[nodiscard]] Index partOf(const BorderEdge3& whole) const {
    const auto isSame = [](const Point3& p, const Point3& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
    const Rational dx = whole.to.x - whole.from.x, dy = whole.to.y - whole.from.y;
    for (std::size_t i = 0; i < borders.size(); ++i) {
      const Rational x = borders[i].to.x - whole.from.x, y = borders[i].to.y - whole.from.y;
      if (isSame(borders[i].from, whole.from) && dx * y == dy * x && dx * x + dy * y > 0) return parts[i];
    }
    return -1;
  }
};

/// The borders that a pipeline leaves, whole.
inline std::vector<BorderEdge3> bordersOf(const std::shared_ptr<const Environment>& environment,
                                          const std::string& pipeline) {
  RunContext context;
  ExactFallbacks fallbacks;
  return ExactBorders(withMesh(runFilters(environment, pipeline), context, fallbacks)).borders;
}

}  // namespace footfall::test
