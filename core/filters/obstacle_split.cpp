// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/obstacle_split.hpp"

#include <oneapi/tbb/parallel_sort.h>

#include <unordered_map>

#include "core/filters/disjoint_sets.hpp"
#include "core/filters/triangle_split.hpp"

namespace footfall {
namespace {

int next(int k) { return k == 2 ? 0 : k + 1; }

struct EdgeUse {
  Index a, b;  ///< a < b
  Index triangle;
  std::int8_t k;
};

Index cornerOf(const MeshTriangle& t, Index vertex) {
  return t.corners[0] == vertex ? 0 : t.corners[1] == vertex ? 1 : 2;
}

}  // namespace

SplitMesh splitAtObstacleEdges(const WalkableMesh& mesh) {
  const auto& triangles = mesh.triangles;
  std::vector<char> atObstacle(mesh.vertices.size(), 0);
  for (const MeshTriangle& t : triangles)
    for (int k = 0; k < 3; ++k)
      if ((t.obstacleEdges >> k & 1) != 0) atObstacle[t.corners[k]] = atObstacle[t.corners[next(k)]] = 1;
  std::vector<EdgeUse> uses;
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index a = triangles[t].corners[k], b = triangles[t].corners[next(k)];
      if (atObstacle[a] != 0 || atObstacle[b] != 0)
        uses.push_back({std::min(a, b), std::max(a, b), t, static_cast<std::int8_t>(k)});
    }
  tbb::parallel_sort(uses.begin(), uses.end(), [](const EdgeUse& x, const EdgeUse& y) {
    if (x.a != y.a) return x.a < y.a;
    if (x.b != y.b) return x.b < y.b;
    return x.triangle != y.triangle ? x.triangle < y.triangle : x.k < y.k;
  });

  SplitMesh result;
  result.triangles = triangles;
  for (MeshTriangle& t : result.triangles) t.obstacleEdges = 0;
  DisjointSets corners(triangles.size() * 3);
  const auto corner = [&](Index t, Index v) { return 3 * t + cornerOf(triangles[t], v); };
  std::vector<std::array<std::size_t, 2>> obstacles;  // ranges of uses
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    bool wall = false;
    for (; j < uses.size() && uses[j].a == uses[i].a && uses[j].b == uses[i].b; ++j)
      wall = wall || (triangles[uses[j].triangle].obstacleEdges >> uses[j].k & 1) != 0;
    if (!wall) {
      for (std::size_t m = i + 1; m < j; ++m) {
        corners.unite(corner(uses[m].triangle, uses[i].a), corner(uses[i].triangle, uses[i].a));
        corners.unite(corner(uses[m].triangle, uses[i].b), corner(uses[i].triangle, uses[i].b));
      }
    } else if (j - i > 1) {
      obstacles.push_back({i, j});
      for (std::size_t m = i; m < j; ++m)
        result.triangles[uses[m].triangle].obstacleEdges |= static_cast<std::uint8_t>(1 << uses[m].k);
    }
    i = j;
  }

  // Sides that still share both ends get a point in the middle each.
  std::vector<char> needs(triangles.size() * 3, 0);
  for (const auto& [first, last] : obstacles)
    for (std::size_t x = first; x < last; ++x)
      for (std::size_t y = first; y < x; ++y) {
        const EdgeUse &u = uses[x], &v = uses[y];
        if (corners.find(corner(u.triangle, u.a)) != corners.find(corner(v.triangle, v.a)) ||
            corners.find(corner(u.triangle, u.b)) != corners.find(corner(v.triangle, v.b)))
          continue;
        needs[3 * u.triangle + u.k] = needs[3 * v.triangle + v.k] = 1;
      }

  std::unordered_map<Index, Index> copies;
  std::vector<Index> whole(mesh.vertices.size(), -1);
  const auto newVertex = [&](Index origin, std::array<Index, 2> middle) {
    result.origins.push_back(origin);
    result.middles.push_back(middle);
    return static_cast<Index>(result.origins.size()) - 1;
  };
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index v = triangles[t].corners[k];
      Index* slot = &whole[v];
      if (atObstacle[v] != 0) slot = &copies.try_emplace(corners.find(3 * t + k), -1).first->second;
      if (*slot < 0) *slot = newVertex(v, {-1, -1});
      result.triangles[t].corners[k] = *slot;
    }

  std::vector<MeshTriangle> pieces;
  std::vector<std::uint32_t> layers;
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
    if (!mesh.layers.empty()) layers.resize(pieces.size(), mesh.layers[t]);
  }
  result.triangles = std::move(pieces);
  result.layers = std::move(layers);
  return result;
}

}  // namespace footfall
