// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/obstacle_split.hpp"

#include <algorithm>

#include "core/base/disjoint_sets.hpp"
#include "core/base/index_and_box.hpp"
#include "core/mesh/triangle_split.hpp"

namespace footfall::detail {
namespace {

Index cornerOf(const MeshTriangle& t, Index vertex) {
  return t.corners[0] == vertex ? 0 : t.corners[1] == vertex ? 1 : 2;
}

}  // namespace

SplitMesh splitAtObstacleEdges(const std::vector<MeshTriangle>& triangles, const std::vector<std::uint32_t>& layers,
                               std::size_t vertexCount, const Adjacency& adjacency, Poll poll) {
  const TriangleCorners cornersOf(triangles);
  SplitMesh result;
  result.triangles = triangles;
  result.layers = layers;
  std::vector<char> atObstacle(vertexCount, 0);
  bool any = false;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (triangles[t].obstacleEdges == 0) continue;
    any = true;
    result.triangles[t].obstacleEdges = 0;
    for (int k = 0; k < 3; ++k)
      if ((triangles[t].obstacleEdges >> k & 1) != 0)
        atObstacle[triangles[t].corners[k]] = atObstacle[triangles[t].corners[next(k)]] = 1;
  }

  poll();
  DisjointSets corners(any ? triangles.size() * 3 : 0);
  const auto corner = [&](Index side, Index v) { return side - side % 3 + cornerOf(triangles[side / 3], v); };
  std::vector<Index> obstacles;  // edges
  for (Index e = 0; any && e < adjacency.edgeCount(); ++e) {
    const auto sides = adjacency.sidesOf(e);
    const Index a = cornersOf.beginOf(sides[0]), b = cornersOf.endOf(sides[0]);
    if (sides.size() < 2 || (atObstacle[a] == 0 && atObstacle[b] == 0)) continue;
    if (isObstacle(triangles, sides)) {
      obstacles.push_back(e);
      for (const Index side : sides)
        result.triangles[side / 3].obstacleEdges |= static_cast<std::uint8_t>(1 << side % 3);
      continue;
    }
    for (const Index side : sides.subspan(1))
      for (const Index v : {a, b}) corners.unite(corner(side, v), corner(sides[0], v));
  }

  poll();
  // Sides that still share both ends get a point in the middle each.
  std::vector<char> needs;
  for (const Index e : obstacles) {
    const auto sides = adjacency.sidesOf(e);
    const Index a = cornersOf.beginOf(sides[0]), b = cornersOf.endOf(sides[0]);
    for (std::size_t x = 0; x < sides.size(); ++x)
      for (std::size_t y = 0; y < x; ++y) {
        if (corners.find(corner(sides[x], a)) != corners.find(corner(sides[y], a)) ||
            corners.find(corner(sides[x], b)) != corners.find(corner(sides[y], b)))
          continue;
        needs.resize(triangles.size() * 3, 0);
        needs[sides[x]] = needs[sides[y]] = 1;
      }
  }

  poll();
  std::vector<Index> copies(any ? triangles.size() * 3 : 0, -1);  // a copy for the first corner of each set
  std::vector<Index> whole(vertexCount, -1);
  const auto newVertex = [&](Index origin, std::array<Index, 2> middle) {
    result.vertices.push_back({origin, middle});
    return static_cast<Index>(result.vertices.size()) - 1;
  };
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index v = triangles[t].corners[k];
      Index& slot = atObstacle[v] != 0 ? copies[corners.find(3 * t + k)] : whole[v];
      if (slot < 0) slot = newVertex(v, {-1, -1});
      result.triangles[t].corners[k] = slot;
    }
  if (needs.empty()) return result;
  poll();

  std::vector<MeshTriangle> pieces;
  std::vector<std::uint32_t> layersOfPieces;
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    EdgeVertices on{};
    std::array<std::vector<Index>, 3> inner;
    for (int k = 0; k < 3; ++k) {
      if (needs[3 * t + k] == 0) continue;
      const Index a = triangles[t].corners[k], b = triangles[t].corners[next(k)];
      inner[k] = {newVertex(-1, {std::min(a, b), std::max(a, b)})};
      on[k] = &inner[k];
    }
    splitTriangle(result.triangles[t], on, pieces);
    if (!layers.empty()) layersOfPieces.resize(pieces.size(), layers[t]);
  }
  result.triangles = std::move(pieces);
  result.layers = std::move(layersOfPieces);
  return result;
}

}  // namespace footfall::detail
