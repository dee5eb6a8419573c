// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/mesh_topology.hpp"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>

#include "core/filters/disjoint_sets.hpp"

namespace footfall {

MeshTopology findEdges(const WalkableMesh& mesh) {
  std::vector<std::array<Index, 3>> sides;
  sides.reserve(mesh.triangles.size() * 3);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const auto& c = mesh.triangles[t].corners;
    for (int k = 0; k < 3; ++k) {
      const Index a = c[k], b = c[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), 3 * t + k});
    }
  }
  tbb::parallel_sort(sides.begin(), sides.end());
  MeshTopology topology;
  topology.uses.reserve(sides.size());
  for (const auto& [low, high, side] : sides) {
    if (topology.edges.empty() || topology.edges.back().low != low || topology.edges.back().high != high)
      topology.edges.push_back({low, high, static_cast<Index>(topology.uses.size()), 0, false});
    MeshEdge& edge = topology.edges.back();
    ++edge.useCount;
    edge.obstacle = edge.obstacle || (mesh.triangles[side / 3].obstacleEdges >> (side % 3) & 1) != 0;
    topology.uses.push_back(side);
  }
  return topology;
}

std::vector<Index> findRegions(const WalkableMesh& mesh, const MeshTopology& topology, Index& regionCount) {
  DisjointSets sets(mesh.triangles.size());
  for (const MeshEdge& e : topology.edges) {
    if (e.obstacle) continue;
    for (Index u = 1; u < e.useCount; ++u) sets.unite(topology.uses[e.firstUse] / 3, topology.uses[e.firstUse + u] / 3);
  }
  std::vector<Index> region(mesh.triangles.size());
  regionCount = 0;
  for (Index t = 0; t < static_cast<Index>(region.size()); ++t)
    region[t] = sets.find(t) == t ? regionCount++ : region[sets.find(t)];
  return region;
}

std::uint64_t countConnections(const WalkableMesh& mesh) {
  if (mesh.layers.empty()) return 0;
  const MeshTopology topology = findEdges(mesh);
  return static_cast<std::uint64_t>(std::count_if(topology.edges.begin(), topology.edges.end(), [&](const MeshEdge& e) {
    bool differ = false;
    for (Index u = 1; u < e.useCount && !e.obstacle; ++u)
      differ = differ || mesh.layers[topology.uses[e.firstUse] / 3] != mesh.layers[topology.uses[e.firstUse + u] / 3];
    return differ;
  }));
}

}  // namespace footfall
