// The meaning of the edges of a walkable mesh: obstacles, regions, connections.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/adjacency.hpp"
#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

inline bool hasObstacle(const std::vector<MeshTriangle>& triangles, Index side) {
  return (triangles[side / 3].obstacleEdges >> (side % 3) & 1) != 0;
}

/// An obstacle stands on the edge of these sides, seen from any of its triangles.
inline bool isObstacle(const std::vector<MeshTriangle>& triangles, std::span<const Index> sides) {
  for (const Index side : sides)
    if (hasObstacle(triangles, side)) return true;
  return false;
}

/// Finds edges and sides by their vertices. The triangles and their topology must outlive it.
class SideFinder {
 public:
  /// `searches` is the number of searches to come, about: many are worth a list of the edges at each vertex.
  SideFinder(const std::vector<MeshTriangle>& triangles, const Adjacency& topology, std::size_t searches);

  /// The edge between two vertices, or -1.
  [[nodiscard]] Index edgeBetween(Index a, Index b) const;
  /// The side of a triangle that goes from vertex `from` to vertex `to`, or -1.
  [[nodiscard]] Index find(Index from, Index to) const;

 private:
  TriangleCorners corners_;
  const Adjacency& topology_;
  /// The first edge with each vertex as the smaller one, and the end; empty for few searches.
  std::vector<Index> firstEdge_;
};

/// The same for a single one.
Index findSide(const std::vector<MeshTriangle>& triangles, const Adjacency& topology, Index from, Index to);

/// The links whose two edges are sides of some of `triangles`, which are over the same vertices; `topology` is theirs.
std::vector<MeshLink> linksBetween(const std::vector<MeshLink>& all, const std::vector<MeshTriangle>& triangles,
                                   const Adjacency& topology);

/// The drops of `mesh` whose edge is a side of some of `triangles`, which are over the same vertices, and whose landing
/// is among them: `renumbered` has for each triangle of `mesh` its number there, or -1; `topology` is theirs.
std::vector<MeshDrop> dropsBetween(const WalkableMesh& mesh, const std::vector<MeshTriangle>& triangles,
                                   const std::vector<Index>& renumbered, const Adjacency& topology);

/// The region of each triangle: triangles that share an edge which is not an obstacle edge, or are linked by a step,
/// belong to one (docs/explanation/model.md, Terms). Regions are numbered from 0 in the order of their first triangles.
std::vector<Index> findRegions(const WalkableMesh& mesh, const Adjacency& topology, Index& regionCount);

/// Edges on which two layers meet, without links; 0 when there are no layers.
std::uint64_t countConnections(const WalkableMesh& mesh, const Adjacency& topology);

}  // namespace footfall::detail
