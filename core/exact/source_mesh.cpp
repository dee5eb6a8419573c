// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/source_mesh.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/exact/source_predicates.hpp"

namespace footfall {

void chooseGrid(SourceMesh& mesh) {
  for (const Vec3& v : mesh.vertices) {
    mesh.grid.include(v.x);
    mesh.grid.include(v.y);
    mesh.grid.include(v.z);
  }
  const int scale = mesh.grid.scaleExponent();
  mesh.scaled.resize(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& v = mesh.vertices[i];
    mesh.scaled[i] = {std::ldexp(v.x, scale), std::ldexp(v.y, scale), std::ldexp(v.z, scale)};
  }
}

void classifyTriangle(SourceMesh& mesh, Index t, const SignRule& sign) {
  const auto& [ia, ib, ic] = mesh.triangles[t];
  const Vec3 &a = mesh.scaled[ia], &b = mesh.scaled[ib], &c = mesh.scaled[ic];
  using E = ErrorDouble;
  const std::array<E, 3> u{E(b.x) - E(a.x), E(b.y) - E(a.y), E(b.z) - E(a.z)};
  const std::array<E, 3> v{E(c.x) - E(a.x), E(c.y) - E(a.y), E(c.z) - E(a.z)};
  auto& n = mesh.normals[t];
  n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const Vec3 &ra = mesh.vertices[ia], &rb = mesh.vertices[ib], &rc = mesh.vertices[ic];
  const int facingSign = sign(n[2]);
  mesh.facing[t] = static_cast<std::int8_t>(facingSign != kUnknownSign ? facingSign : facing(ra, rb, rc));
  if (mesh.facing[t] == 0) n[2] = 0;
  mesh.degenerate[t] = static_cast<char>(mesh.facing[t] == 0 && isDegenerate(ra, rb, rc));
  if (mesh.degenerate[t]) n = {};
}

SortedTriangle sortedTriangle(const SourceMesh& mesh, const Triangle& t, std::uint32_t number, bool bothSides) {
  std::array<Index, 3> f{mesh.welded[t[0]], mesh.welded[t[1]], mesh.welded[t[2]]};
  if (bothSides && facing(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]) < 0) std::swap(f[1], f[2]);
  std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  return {f, number};
}

namespace {

// Sorts and welds the used vertices; returns for each input vertex its new index.
std::vector<Index> weldVertices(const std::vector<Vec3>& vertices, SourceMesh& mesh) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return isBefore(vertices[a], vertices[b]) || (vertices[a] == vertices[b] && a < b);
  });
  std::vector<Index> welded(vertices.size());
  for (const std::uint32_t i : order) {
    const Vec3 v = withoutNegativeZeros(vertices[i]);
    if (mesh.vertices.empty() || !(mesh.vertices.back() == v)) {
      const auto index = static_cast<Index>(mesh.vertices.size());
      const bool samePlan = index > 0 && mesh.vertices.back().x == v.x && mesh.vertices.back().y == v.y;
      mesh.planIds.push_back(samePlan ? mesh.planIds.back() : index);
      mesh.vertices.push_back(v);
    }
    welded[i] = static_cast<Index>(mesh.vertices.size()) - 1;
  }
  return welded;
}

void classify(SourceMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  mesh.normals.resize(count);
  mesh.facing.resize(count);
  mesh.degenerate.resize(count);
  const SignRule sign = mesh.grid.signRule(mesh.grid.scaleExponent());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t t = range.begin(); t != range.end(); ++t) classifyTriangle(mesh, static_cast<Index>(t), sign);
  });
}

}  // namespace

bool SourceMesh::hasObstacleEdge(Index a, Index b) const {
  return !obstacleEdges.empty() &&
         std::binary_search(obstacleEdges.begin(), obstacleEdges.end(), std::make_pair(std::min(a, b), std::max(a, b)));
}

SourceMesh makeSourceMesh(const SourceSoup& soup, bool bothSides, std::vector<std::uint32_t>* order,
                          const std::function<void()>& poll) {
  SourceMesh mesh;
  mesh.welded = weldVertices(soup.vertices, mesh);
  const std::vector<Index>& welded = mesh.welded;
  poll();
  chooseGrid(mesh);
  poll();

  std::vector<SortedTriangle> entries(soup.triangles.size());
  tbb::parallel_for(std::size_t{0}, soup.triangles.size(), [&](std::size_t i) {
    entries[i] = sortedTriangle(mesh, soup.triangles[i], static_cast<std::uint32_t>(i), bothSides);
  });
  poll();
  tbb::parallel_sort(entries.begin(), entries.end());
  mesh.triangles.reserve(entries.size());
  mesh.inputTriangles.reserve(entries.size());
  if (order != nullptr) order->clear();
  for (const SortedTriangle& entry : entries) {
    mesh.triangles.push_back(entry.corners);
    mesh.inputTriangles.push_back(soup.inputTriangles.empty() ? entry.number : soup.inputTriangles[entry.number]);
    if (order != nullptr) order->push_back(entry.number);
  }
  for (const auto& [u, v] : soup.obstacleEdges)
    if (welded[u] != welded[v])
      mesh.obstacleEdges.emplace_back(std::min(welded[u], welded[v]), std::max(welded[u], welded[v]));
  std::sort(mesh.obstacleEdges.begin(), mesh.obstacleEdges.end());
  mesh.obstacleEdges.erase(std::unique(mesh.obstacleEdges.begin(), mesh.obstacleEdges.end()), mesh.obstacleEdges.end());
  poll();
  classify(mesh);
  poll();

  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  boxes.reserve(entries.size());
  ids.reserve(entries.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.degenerate[t]) continue;
    const auto& f = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
    boxes.push_back({{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                     {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
    ids.push_back(static_cast<std::int32_t>(t));
  }
  mesh.tree.build(std::move(boxes), std::move(ids), poll);
  return mesh;
}

}  // namespace footfall
