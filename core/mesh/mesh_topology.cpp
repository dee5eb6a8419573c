// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_topology.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <iterator>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"

namespace footfall::detail {
namespace {

constexpr Index kEdgesPerTask = 2048;

}  // namespace

bool isObstacle(const std::vector<MeshTriangle>& triangles, std::span<const Index> sides) {
  return std::any_of(sides.begin(), sides.end(), [&](Index side) { return hasObstacle(triangles, side); });
}

Index findSide(const std::vector<MeshTriangle>& triangles, const Adjacency& topology, Index from, Index to) {
  const TriangleCorners corners(triangles);
  const std::pair key = std::minmax(from, to);
  Index low = 0, high = topology.edgeCount();
  const auto keyOf = [&](Index edge) {
    const Index side = topology.sidesOf(edge)[0];
    const Index a = corners.beginOf(side), b = corners.endOf(side);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    if (keyOf(middle) < std::pair<Index, Index>(key))
      low = middle + 1;
    else
      high = middle;
  }
  if (low == topology.edgeCount() || keyOf(low) != std::pair<Index, Index>(key)) return -1;
  for (const Index side : topology.sidesOf(low))
    if (corners.beginOf(side) == from) return side;
  return -1;
}

std::vector<MeshLink> linksBetween(const std::vector<MeshLink>& all, const std::vector<MeshTriangle>& triangles,
                                   const Adjacency& topology) {
  const auto isThere = [&](const std::array<Index, 2>& edge) {
    return findSide(triangles, topology, edge[0], edge[1]) >= 0;
  };
  std::vector<MeshLink> links;
  std::copy_if(all.begin(), all.end(), std::back_inserter(links),
               [&](const MeshLink& link) { return isThere(link.from) && isThere(link.to); });
  return links;
}

std::vector<MeshDrop> dropsBetween(const WalkableMesh& mesh, const std::vector<MeshTriangle>& triangles,
                                   const std::vector<Index>& renumbered, const Adjacency& topology) {
  std::vector<MeshDrop> drops;
  for (MeshDrop drop : mesh.drops) {
    drop.triangle = renumbered[drop.triangle];
    if (drop.triangle >= 0 && findSide(triangles, topology, drop.edge[0], drop.edge[1]) >= 0) drops.push_back(drop);
  }
  return drops;
}

std::vector<Index> findRegions(const WalkableMesh& mesh, const Adjacency& topology, Index& regionCount) {
  std::vector<char> joins(static_cast<std::size_t>(topology.edgeCount()));
  parallelRanges(topology.edgeCount(), kEdgesPerTask, [&](const auto& range) {
    for (Index e = range.begin(); e != range.end(); ++e) {
      const auto sides = topology.sidesOf(e);
      joins[e] = static_cast<char>(sides.size() >= 2 && !isObstacle(mesh.triangles, sides));
    }
  });
  DisjointSets sets(mesh.triangles.size());
  for (Index e = 0; e < topology.edgeCount(); ++e) {
    if (joins[e] == 0) continue;
    const auto sides = topology.sidesOf(e);
    for (const Index side : sides.subspan(1)) sets.unite(sides[0] / 3, side / 3);
  }
  for (const MeshLink& link : mesh.links) {
    const Index from = findSide(mesh.triangles, topology, link.from[0], link.from[1]);
    const Index to = findSide(mesh.triangles, topology, link.to[0], link.to[1]);
    if (from >= 0 && to >= 0) sets.unite(from / 3, to / 3);
  }
  return sets.numbers(regionCount);
}

std::uint64_t countConnections(const WalkableMesh& mesh, const Adjacency& topology) {
  if (mesh.layers.empty()) return 0;
  std::atomic<std::uint64_t> connections{0};
  parallelRanges(topology.edgeCount(), kEdgesPerTask, [&](const auto& range) {
    std::uint64_t here = 0;
    for (Index e = range.begin(); e != range.end(); ++e) {
      const auto sides = topology.sidesOf(e);
      const auto differs = [&](Index side) { return mesh.layers[side / 3] != mesh.layers[sides[0] / 3]; };
      here += static_cast<std::uint64_t>(std::any_of(sides.begin(), sides.end(), differs) &&
                                         !isObstacle(mesh.triangles, sides));
    }
    connections.fetch_add(here, std::memory_order_relaxed);
  });
  return connections;
}

}  // namespace footfall::detail
