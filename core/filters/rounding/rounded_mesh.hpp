// The one place where coordinates are rounded, and where what rounding can break is repaired (model, Exact decisions,
// thesis 4.4.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The number of triangles of each geometry case that rounding met.
struct RoundingCases {
  std::uint64_t exact = 0;      ///< case 1: all corners are doubles already
  std::uint64_t edge = 0;       ///< case 2: two corners fell together
  std::uint64_t point = 0;      ///< case 3: all corners fell together
  std::uint64_t collinear = 0;  ///< case 4
  std::uint64_t flipped = 0;    ///< case 5
  std::uint64_t crowded = 0;    ///< none of these, but a needle on the same side of an edge as another triangle
  /// Vertices that went, each with the one that stands for it, in the order in which they went.
  std::vector<std::array<Index, 2>> collapsed;

  /// True when something had to be repaired.
  [[nodiscard]] bool anyBroken() const { return edge + point + collinear + flipped + crowded != 0; }
};

/// A mesh with rounded vertices, in the environment's units.
using RoundedMesh = TriangleMesh<Vec3>;

/// Positions of all vertices, each coordinate the nearest double to the exact one. `exact[v]` is 1 where none was lost.
std::vector<Vec3> roundVertices(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices,
                                std::vector<char>& exact, RunContext& context);

/// Removes every triangle that is degenerate or turned over, by collapsing edges as short as rounding errors, by
/// handing a corner that fell onto (or beyond) the opposite edge to the neighbour there, or, at the border, by dropping
/// it; obstacle flags move to the neighbours (algorithm 3). Where that comes to no end, because needles turned each
/// other's corners over, edges are snapped to the vertices that they pass (snapped_needles.hpp). Afterwards every
/// triangle faces up, exactly. `sturdy[v]`: prefer to keep this vertex's place. `crowded`: what markBorders() returned.
///
/// Nothing goes farther than 2^-42 of the largest coordinate: no edge is farther than that from the chain of edges that
/// takes its place, and what went was no wider. Each repair adds to what those before it did to the same triangles the
/// length of the edge that it collapses, how far the corner is from the edge onto which it fell, or how far edges are
/// snapped, at most 2^-44; where one would add more, it is not made.
RoundingCases repairRounding(RoundedMesh& mesh, const std::vector<char>& sturdy, RunContext& context,
                             const std::vector<Index>& crowded = {});

/// Sets the obstacle flag of every edge with a triangle on one side only, so that repairs carry along what is a border.
/// Returns the triangles of edges with several on one side: floors that begin at one line overlap by a rounding.
std::vector<Index> markBorders(RoundedMesh& mesh, const Adjacency& topology);

/// Called after the repairs: borders lose that flag again; where repairs joined a border with another edge by index, it
/// is an obstacle edge on all its sides. Returns whether there are obstacle edges whose sides share vertices.
bool settleBorders(RoundedMesh& mesh, const Adjacency& topology);

/// Obstacle edges whose sides share vertices become inner edges. It is for those that cannot be split: with both ends
/// inside the area, and no double between these that would be a vertex of either side.
void dropSharedObstacles(RoundedMesh& mesh, const Adjacency& topology);

/// Borders that coincide without being joined, after rounding closed a sliver or two surfaces came to lie against each
/// other, become obstacle edges, so that a reader who welds by position sees it. Borders that coincide in part only are
/// split where the common part ends; then the result is true, and the topology has changed.
///
/// `suspects` (one for each vertex, or empty for all): a border can only coincide with another when an end of one of
/// the two is a suspect. In a mesh that is as it was assembled, those are the vertices that rounding moved and the ends
/// of obstacle edges: before rounding the mesh is conforming, so borders that have a piece in common are one edge
/// there, or the two sides of an obstacle edge; and if no end of two borders moved, they have in common what they had
/// before.
bool markClosedSlivers(RoundedMesh& mesh, const Adjacency& topology, const std::vector<char>& suspects,
                       RunContext& context);

}  // namespace footfall::detail
