// A mesh of walkable parts with exact vertices.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "core/exact/plan_kernel.hpp"

namespace footfall::detail {

/// A vertex is a plan point lifted to the plane of a face; its rounded place serves filters and display.
struct MeshVertex {
  PlanPoint point;
  Index face = -1;    ///< a source triangle whose plane holds the vertex
  Index source = -1;  ///< the source vertex that it is, or -1 for a constructed one
  /// Scaled coordinates (SourceMesh::scaled), each within `error` of the exact ones.
  double x = 0, y = 0, z = 0;
  double error = 0;
};

struct MeshTriangle {
  std::array<Index, 3> corners{};  ///< counter-clockwise from above
  Index face = -1;                 ///< a source triangle in whose plane it lies
  std::uint8_t obstacleEdges = 0;  ///< bit k: an obstacle stands on the edge from corner k to k + 1
};

/// Triangles over vertices of some kind.
template <class Vertex>
struct TriangleMesh {
  std::vector<Vertex> vertices;
  std::vector<MeshTriangle> triangles;
  std::vector<std::uint32_t> layers;  ///< one for each triangle, or empty
};

/// Two edges of the border over which an agent steps from one to the other. Each goes from its first vertex to its
/// second with walkable area on its left; in the plan the second runs along the first, backwards, and where there is a
/// gap between them, lies to its right.
struct MeshLink {
  std::array<Index, 2> from{}, to{};
  bool isGap = false;
  auto operator<=>(const MeshLink&) const = default;
};

/// A stretch of an edge of the border from which one drops into a triangle. Places are scaled coordinates, rounded.
struct MeshDrop {
  std::array<Index, 2> edge{};                              ///< its vertices, with walkable area on its left
  Index triangle = -1;                                      ///< triangle of the landing
  std::array<double, 2> stretch{};                          ///< part of the edge: 0 at its first vertex, 1 at its
                                                            ///< second
  std::array<std::array<double, 3>, 2> start{}, landing{};  ///< places at the ends of the stretch
  auto operator<=>(const MeshDrop&) const = default;
};

/// The walkable area, conforming: triangles that meet share whole edges, by vertex index. Both sides of an obstacle
/// edge still have the same vertices here; the flag distinguishes them, and they are split when the product is made.
struct WalkableMesh : TriangleMesh<MeshVertex> {
  std::vector<MeshLink> links;  ///< ascending
  std::vector<MeshDrop> drops;  ///< ascending
  std::uint32_t layerCount = 0;
};

}  // namespace footfall::detail
