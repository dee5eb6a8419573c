// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of what a subdivision into layers needs, from floors over one place.
//
// Floors over one place lie in different layers, since no layer lies above itself. So the number of triangles that hold
// a place inside them, away from their sides, is a proven lower bound. Places near the corners of triangles are tried,
// because every set of floors that overlap has a corner of one of them, or a crossing of two sides, at its rim. Those
// of the last layers are tried first: a triangle gets a late layer because it overlaps the earlier ones.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "core/base/box_tree.hpp"
#include "core/base/parallel.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/mesh/adjacency.hpp"
#include "footfall/inspect.hpp"

namespace footfall {
namespace {

using detail::Index;
using PlanTree = detail::BoxTree<2>;

constexpr std::size_t kMostTriangles = 4096;

PlanTree::Bounds boundsOf(const NavigationMesh& mesh, Index triangle) {
  PlanTree::Bounds bounds;
  const Triangle& corners = mesh.triangles[triangle];
  const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
  bounds.lower = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
  bounds.upper = {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
  return bounds;
}

/// True when the place lies inside the triangle in the plan, and on none of its sides.
bool holds(const NavigationMesh& mesh, Index triangle, const Vec3& place) {
  const Triangle& corners = mesh.triangles[triangle];
  const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
  return detail::facing(a, b, place) > 0 && detail::facing(b, c, place) > 0 && detail::facing(c, a, place) > 0;
}

/// The middle of a triangle, and a place near each of its corners. Rounding may move one to another triangle: that
/// place is as good.
std::array<Vec3, 4> placesIn(const NavigationMesh& mesh, Index triangle) {
  const Triangle& corners = mesh.triangles[triangle];
  std::array<Vec3, 4> places{};
  for (const std::size_t i : {0, 1, 2}) {
    places[3].x += mesh.vertices[corners[i]].x / 3;
    places[3].y += mesh.vertices[corners[i]].y / 3;
  }
  constexpr double kInwards = 0x1p-10;
  for (const std::size_t i : {0, 1, 2}) {
    const Vec3& corner = mesh.vertices[corners[i]];
    places[i].x = std::lerp(corner.x, places[3].x, kInwards);
    places[i].y = std::lerp(corner.y, places[3].y, kInwards);
  }
  return places;
}

/// The triangles whose places are tried, those of the last layers first.
std::vector<Index> triangleOrder(const NavigationMesh& mesh) {
  std::vector<Index> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  const std::size_t tried = std::min(order.size(), kMostTriangles);
  std::partial_sort(
      order.begin(), order.begin() + static_cast<std::ptrdiff_t>(tried), order.end(),
      [&](Index a, Index b) { return mesh.layers[a] != mesh.layers[b] ? mesh.layers[a] > mesh.layers[b] : a < b; });
  order.resize(tried);
  return order;
}

PlanTree treeOf(const NavigationMesh& mesh) {
  std::vector<Index> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  PlanTree tree;
  tree.build(all, [&](Index t) { return boundsOf(mesh, t); }, {});
  return tree;
}

/// Calls visit(t) for each triangle that holds the place.
template <class Visit>
void visitFloors(const NavigationMesh& mesh, const PlanTree& tree, const Vec3& place, const Visit& visit) {
  tree.visitOverlapping({{place.x, place.y}, {place.x, place.y}}, [&](Index t) {
    if (holds(mesh, t, place)) visit(t);
  });
}

void raise(std::atomic<std::uint32_t>& most, std::uint32_t count) {
  std::uint32_t seen = most;
  while (count > seen && !most.compare_exchange_weak(seen, count)) {
  }
}

/// The triangles whose places are tried of parts in several layers: of each part some of its last layers.
std::vector<Index> triangleOrder(const NavigationMesh& mesh, const std::vector<Index>& part, Index partCount) {
  constexpr Index kMostOfPart = 64;
  std::vector<std::array<std::uint32_t, 2>> range(partCount, {mesh.layerCount, 0});
  for (std::size_t t = 0; t < part.size(); ++t) {
    auto& [least, greatest] = range[part[t]];
    least = std::min(least, mesh.layers[t]);
    greatest = std::max(greatest, mesh.layers[t]);
  }
  std::vector<Index> order;
  for (std::size_t t = 0; t < part.size(); ++t)
    if (range[part[t]][0] < range[part[t]][1]) order.push_back(static_cast<Index>(t));
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    if (part[a] != part[b]) return part[a] < part[b];
    return mesh.layers[a] != mesh.layers[b] ? mesh.layers[a] > mesh.layers[b] : a < b;
  });
  std::vector<Index> count(partCount, 0);
  order.erase(std::remove_if(order.begin(), order.end(), [&](Index t) { return ++count[part[t]] > kMostOfPart; }),
              order.end());
  order.resize(std::min(order.size(), kMostTriangles));
  return order;
}

}  // namespace

std::uint32_t leastLayers(const NavigationMesh& mesh) {
  if (mesh.layerCount <= 1) return mesh.layerCount;
  const PlanTree tree = treeOf(mesh);
  const std::vector<Index> order = triangleOrder(mesh);
  std::atomic<std::uint32_t> most = 1;
  detail::parallelFor(order.size(), [&](std::size_t i) {
    if (most >= mesh.layerCount) return;  // no more floors than layers can lie over a place
    for (const Vec3& place : placesIn(mesh, order[i])) {
      std::uint32_t floors = 0;
      visitFloors(mesh, tree, place, [&](Index) { ++floors; });
      raise(most, floors);
    }
  });
  return most;
}

std::size_t leastConnections(const NavigationMesh& mesh) {
  if (mesh.connections.empty() || mesh.layers.empty()) return 0;
  Index partCount = 0;
  const std::vector<Index> part = detail::findParts(mesh.triangles, mesh.vertices.size(), partCount);
  const PlanTree tree = treeOf(mesh);
  const std::vector<Index> order = triangleOrder(mesh, part, partCount);
  std::vector<std::atomic<std::uint32_t>> most(static_cast<std::size_t>(partCount));
  detail::parallelFor(order.size(), [&](std::size_t i) {
    for (const Vec3& place : placesIn(mesh, order[i])) {
      std::uint32_t floors = 0;
      visitFloors(mesh, tree, place, [&](Index t) { floors += part[t] == part[order[i]] ? 1 : 0; });
      raise(most[part[order[i]]], floors);
    }
  });
  std::size_t least = 0;
  for (const auto& floors : most) least += std::max<std::uint32_t>(floors, 1) - 1;
  return least;
}

}  // namespace footfall
