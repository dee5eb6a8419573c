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
// A search among all edges takes about as long as the list for so many edges.
constexpr std::size_t kEdgesPerSearch = 8;

}  // namespace

SideFinder::SideFinder(const std::vector<MeshTriangle>& triangles, const Adjacency& topology, std::size_t searches)
    : corners_(triangles), topology_(topology) {
  const Index count = topology.edgeCount();
  if (searches * kEdgesPerSearch < static_cast<std::size_t>(count)) return;
  const auto smallerOf = [&](Index edge) {
    const Index side = topology.sides[topology.first[edge]], t = side / 3, k = side - 3 * t;
    const Index* const c = corners_[t];
    return std::min(c[k], c[k == 2 ? 0 : k + 1]);
  };
  if (count == 0) return;
  firstEdge_.resize(static_cast<std::size_t>(smallerOf(count - 1)) + 2, count);
  Index next = 0;
  for (Index e = 0; e < count; ++e)
    for (const Index vertex = smallerOf(e); next <= vertex; ++next) firstEdge_[next] = e;
}

Index SideFinder::edgeBetween(Index a, Index b) const {
  const std::pair<Index, Index> key(std::min(a, b), std::max(a, b));
  const auto keyOf = [&](Index edge) {
    const Index side = topology_.sidesOf(edge)[0];
    const Index begin = corners_.beginOf(side), end = corners_.endOf(side);
    return std::pair<Index, Index>(std::min(begin, end), std::max(begin, end));
  };
  Index low = 0, high = topology_.edgeCount();
  if (!firstEdge_.empty()) {
    if (static_cast<std::size_t>(key.first) + 1 >= firstEdge_.size()) return -1;
    low = firstEdge_[key.first];
    high = firstEdge_[key.first + 1];
  }
  const Index behind = high;
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    if (keyOf(middle) < key)
      low = middle + 1;
    else
      high = middle;
  }
  return low < behind && keyOf(low) == key ? low : -1;
}

Index SideFinder::find(Index from, Index to) const {
  const Index edge = edgeBetween(from, to);
  if (edge < 0) return -1;
  for (const Index side : topology_.sidesOf(edge))
    if (corners_.beginOf(side) == from) return side;
  return -1;
}

Index findSide(const std::vector<MeshTriangle>& triangles, const Adjacency& topology, Index from, Index to) {
  return SideFinder(triangles, topology, 0).find(from, to);
}

std::vector<MeshLink> linksBetween(const std::vector<MeshLink>& all, const std::vector<MeshTriangle>& triangles,
                                   const Adjacency& topology) {
  std::vector<MeshLink> links;
  if (all.empty()) return links;
  const SideFinder sides(triangles, topology, 2 * all.size());
  const auto isThere = [&](const std::array<Index, 2>& edge) { return sides.find(edge[0], edge[1]) >= 0; };
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
  if (!mesh.links.empty()) {
    const SideFinder finder(mesh.triangles, topology, 2 * mesh.links.size());
    for (const MeshLink& link : mesh.links) {
      const Index from = finder.find(link.from[0], link.from[1]), to = finder.find(link.to[0], link.to[1]);
      if (from >= 0 && to >= 0) sets.unite(from / 3, to / 3);
    }
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
