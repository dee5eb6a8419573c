// The product as other programs see it: rounded vertices, shared by index exactly where an agent can cross.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "footfall/geometry.hpp"

namespace footfall {

enum class StepKind : std::uint32_t {
  Step,  ///< the two edges lie over each other in the plan
  Gap    ///< they lie beside each other, with a gap between them
};

/// Two edges of the border between which an agent steps, in both directions. Lengths are in the environment's units.
struct StepLink {
  /// Vertices of each edge, with the walkable area on its left; seen from above the second runs along the first,
  /// backwards. A step has from[0] at to[1] and from[1] at to[0]. Over a gap, ways lead from each place of the first
  /// edge to the place of the second one that divides it in the same ratio.
  std::array<std::uint32_t, 2> from{}, to{};
  std::uint32_t fromTriangle = 0, toTriangle = 0;  ///< whose edges they are
  double height = 0;                               ///< the largest difference in height
  double width = 0;                                ///< longest way over it in the plan; 0 for a step
  StepKind kind = StepKind::Step;
};

/// A stretch of an edge of the border from which an agent drops to what lies lower, one way. Between the two ends both
/// the start and the landing move evenly.
struct DropLink {
  std::array<std::uint32_t, 2> from{};  ///< vertices of the edge, with the walkable area on its left
  std::uint32_t fromTriangle = 0;       ///< whose edge it is
  std::uint32_t toTriangle = 0;         ///< triangle in which the agent lands
  std::array<Vec3, 2> start{};          ///< places on the edge, in its direction, rounded
  std::array<Vec3, 2> landing{};        ///< landing from each of them, in or on the border of `toTriangle`
  double depth = 0;                     ///< the largest difference in height, in the environment's units
  double width = 0;                     ///< distance from the first start to the other one, in the plan
};

/// Triangles that an agent can stand on. Two of them share an edge by its two vertex numbers exactly where the agent
/// can cross it, also from layer to layer; the two sides of an obstacle edge have vertices of their own. Vertices,
/// edges and layers are in an order that depends on the input alone.
struct NavigationMesh {
  std::vector<Vec3> vertices;       ///< Z up, the environment's units
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from above
  /// Layer of each triangle, 0-based; empty when no layer filter ran.
  std::vector<std::uint32_t> layers;
  std::uint32_t layerCount = 0;
  /// An input triangle (index into Environment::triangles) in whose plane each triangle lies.
  std::vector<std::uint32_t> sourceTriangles;
  /// Obstacle edges, each once, as vertex pairs of one of its sides (the other side has vertices of its own).
  std::vector<std::array<std::uint32_t, 2>> obstacleEdges;
  /// Edges on which two layers meet, as vertex pairs.
  std::vector<std::array<std::uint32_t, 2>> connections;
  /// Steps and gaps (StepFilter), in the order of their first edges.
  std::vector<StepLink> links = {};
  /// The file of the environment: where save() puts the mesh back to.
  SourceFrame frame = {};
  /// Drops (DropFilter), in the order of the edges that they start from.
  std::vector<DropLink> drops = {};
};

}  // namespace footfall
