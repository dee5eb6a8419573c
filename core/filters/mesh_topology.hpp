// Edges of a walkable mesh and who shares them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/filters/walkable_state.hpp"

namespace footfall {

/// One use of an edge: triangle `side / 3` has it from its corner `side % 3` to the next one.
struct MeshEdge {
  Index low = -1, high = -1;  ///< vertices, low < high
  Index firstUse = 0;         ///< into MeshTopology::uses
  Index useCount = 0;
  bool obstacle = false;  ///< an obstacle stands on it, seen from any of its triangles
};

struct MeshTopology {
  std::vector<MeshEdge> edges;  ///< sorted by vertices
  std::vector<Index> uses;      ///< sides, grouped by edge, ascending within one
};

MeshTopology findEdges(const WalkableMesh& mesh);

/// For each triangle its region: triangles that share an edge which is not an obstacle edge belong to one (design,
/// AreaFilter). Regions are numbered from 0 in the order of their first triangles.
std::vector<Index> findRegions(const WalkableMesh& mesh, const MeshTopology& topology, Index& regionCount);

/// Edges on which two layers meet; 0 when there are no layers.
std::uint64_t countConnections(const WalkableMesh& mesh);

}  // namespace footfall
