// The edges of a list of triangles, and which triangles share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/triangle_corners.hpp"

namespace footfall::detail {

/// All edges, each as the list of its sides (TriangleCorners). Two sides belong to one edge when they have the same two
/// vertices; a triangle with a corner twice has an edge with one end.
struct Adjacency {
  std::vector<Index>
      sides;  ///< grouped by edge, ascending within one; edges are sorted by their vertices, smaller first
  std::vector<Index> first;  ///< first place of each edge in `sides`, and one more entry at the end

  [[nodiscard]] Index edgeCount() const { return static_cast<Index>(first.size()) - 1; }
  [[nodiscard]] std::span<const Index> sidesOf(Index edge) const {
    return {sides.data() + first[edge], static_cast<std::size_t>(first[edge + 1] - first[edge])};
  }
};

/// Vertices are numbered below `vertexCount`. Linear in the mesh while no vertex has very many edges; on all threads.
/// `poll` is called now and then, from any thread, and may throw to cancel.
Adjacency findEdges(const TriangleCorners& triangles, std::size_t vertexCount, Poll poll = {});

/// The adjacency that findEdges() gives for some of the triangles over the same vertices: `renumbered` holds the
/// ascending number of each triangle among them, or -1.
Adjacency edgesOfSome(const Adjacency& all, const std::vector<Index>& renumbered, Poll poll);

/// The part of each triangle: triangles that share an edge belong to one part. Parts are numbered from 0 in the order
/// of their first triangles. `poll` as above.
std::vector<Index> findParts(const TriangleCorners& triangles, std::size_t vertexCount, Index& partCount,
                             Poll poll = {});

}  // namespace footfall::detail
