// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_topology.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "core/base/disjoint_sets.hpp"

namespace footfall::detail {
namespace {

constexpr Index kEdgesPerTask = 8192;

}  // namespace

bool isObstacle(const std::vector<MeshTriangle>& triangles, std::span<const Index> sides) {
  return std::any_of(sides.begin(), sides.end(), [&](Index side) { return hasObstacle(triangles, side); });
}

std::vector<Index> findRegions(const WalkableMesh& mesh, const Adjacency& topology, Index& regionCount) {
  std::vector<char> joins(static_cast<std::size_t>(topology.edgeCount()));
  tbb::parallel_for(tbb::blocked_range<Index>(0, topology.edgeCount(), kEdgesPerTask), [&](const auto& range) {
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
  return sets.numbers(regionCount);
}

std::uint64_t countConnections(const WalkableMesh& mesh, const Adjacency& topology) {
  if (mesh.layers.empty()) return 0;
  std::atomic<std::uint64_t> connections{0};
  tbb::parallel_for(tbb::blocked_range<Index>(0, topology.edgeCount(), kEdgesPerTask), [&](const auto& range) {
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
