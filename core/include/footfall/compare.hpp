// The difference of two navigation meshes: as exact sets, in the plan, by distances, and in their parts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

/// The area of a surface, in the square of the meshes' unit.
struct SurfaceArea {
  double surface = 0;  ///< area in space
  double plan = 0;     ///< seen from above
};

/// Two surfaces A and B as sets of points.
struct SetDifference {
  /// The parts only in A, only in B and in both, in this order. Their existence is exact; areas are correct to 14
  /// digits.
  std::array<bool, 3> hasArea{};
  std::array<SurfaceArea, 3> areas;
  /// The areas of the triangles of A and of B.
  std::array<std::vector<SurfaceArea>, 2> triangleAreas;
  /// One flag per triangle: set where it is known to lie in the other set. Triangles without the flag may lie there as
  /// well.
  std::array<std::vector<char>, 2> covered;
};

/// The steps of A and of B as sets of points (x, y, lower height, upper height): however they are cut into pairs of
/// edges.
struct LinkDifference {
  /// The lengths only in A, only in B and in both, in this order. Their existence is exact; lengths, in the plan, are
  /// correct to 14 digits.
  std::array<bool, 3> hasLength{};
  std::array<double, 3> lengths{};
};

/// Distances from one surface to another one: Euclidean, not squared (thesis 5.5 writes squares, and its tables have
/// distances).
struct SurfaceDistances {
  std::size_t samples = 0;  ///< one at each position that is a corner of a triangle
  double min = 0, max = 0, mean = 0, rms = 0;
  Vec3 farthest;  ///< a sample whose distance is `max`
  /// The one-sided Hausdorff distance, over all points of the surface, lies between these two.
  double lower = 0, upper = 0;
  bool boundReached = true;  ///< upper - lower is at most the requested error
};

struct ComparisonOptions {
  /// The difference in height at which one surface still covers the other, in the file's units; default: 2^-30 of the
  /// largest coordinate, which is far more than rounding vertices to doubles moves them and far less than a step.
  std::optional<double> height;
  /// The distance between the bounds of the Hausdorff distance; default: a thousandth of the diagonal of both meshes.
  std::optional<double> error;
};

/// The content of one layer of a mesh, or of the whole.
struct MeshPart {
  std::string name;  ///< name of the layer; empty for the whole
  std::size_t triangles = 0;
  std::size_t degenerate = 0;  ///< number of triangles without area
  /// Parts that hang together over edges with the same two vertex indices, or over steps.
  std::size_t components = 0;
  SurfaceArea areas;  ///< sum over its triangles
  /// The area that the other mesh does not cover, with heights that differ by at most the tolerance.
  SurfaceArea uncovered;
};

struct MeshDescription {
  MeshPart whole;
  std::vector<MeshPart> layers;  ///< empty when the file has none
  std::size_t vertices = 0;      ///< vertices of the file
  std::size_t positions = 0;     ///< different ones that triangles use
  std::size_t connections = 0, obstacleEdges = 0;
  double connectionLength = 0, obstacleEdgeLength = 0;
  std::size_t links = 0;   ///< steps and gaps, as pairs of edges
  std::size_t gaps = 0;    ///< number of gaps among the links
  double linkLength = 0;   ///< length of all links, in the plan
  double highestLink = 0;  ///< the largest difference in height on one; 0 without any
  double widestGap = 0;    ///< width in the plan; 0 without any gap
  std::size_t drops = 0;
  double dropLength = 0;   ///< length of all drops, along the borders that they start from, in the plan
  double deepestDrop = 0;  ///< 0 without any
};

/// Two meshes compared. A is the ground truth where one is needed (thesis 5.5).
struct MeshComparison {
  std::array<MeshDescription, 2> meshes;
  SetDifference sets;
  LinkDifference links;
  /// True when both have the same drops: the same starts and landings, exactly, in any order.
  bool equalDrops = true;
  double height = 0;
  double error = 0;
  /// A to B and B to A; none when a mesh is empty.
  std::optional<std::array<SurfaceDistances, 2>> distances;

  /// True when both are the same set of points, exactly: whatever their triangulation, winding and order. Steps are no
  /// part of it.
  [[nodiscard]] bool equal() const { return !sets.hasArea[0] && !sets.hasArea[1]; }
  /// True when both have the same steps, exactly.
  [[nodiscard]] bool hasEqualLinks() const { return !links.hasLength[0] && !links.hasLength[1]; }
  /// Share of A's surface that B covers within the height; 1 for an empty A.
  [[nodiscard]] double covered() const;
  /// Area of B over area of A: "walkable space covered" as thesis 5.5 computes it. None for an empty A.
  [[nodiscard]] std::optional<double> areaRatio() const;
};

/// Compares two meshes of one frame: the same units, Z up. Only the positions of their triangles count for `sets` and
/// distances. On all threads; the same input gives the same result. Throws InputError for a height or error that is no
/// finite number above or, for the height, at 0; Cancelled when `context` (may be null) was cancelled.
MeshComparison compareMeshes(const NavigationMesh& a, const NavigationMesh& b, const ComparisonOptions& options = {},
                             RunContext* context = nullptr);

}  // namespace footfall
