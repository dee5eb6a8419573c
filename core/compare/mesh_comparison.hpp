// How two navigation meshes differ: as exact sets, in the plan, by distances, and in what they are made of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/compare/comparison_distances.hpp"
#include "core/compare/comparison_sets.hpp"
#include "core/io/navigation_mesh_reader.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

struct ComparisonOptions {
  /// How far heights may differ where one surface still covers the other, in the file's units; default: 2^-30 of the
  /// largest coordinate, which is far more than rounding vertices to doubles moves them and far less than a step.
  std::optional<double> height;
  /// How close the bounds of the Hausdorff distance are to be; default: a thousandth of the diagonal of both meshes.
  std::optional<double> error;
};

/// What one layer, or the whole, of a mesh consists of.
struct MeshPart {
  std::string name;  ///< of the layer; empty for the whole
  std::size_t triangles = 0;
  std::size_t degenerate = 0;  ///< of them, triangles without area
  std::size_t components = 0;  ///< parts that hang together over edges with the same two vertex indices
  comparison::Areas areas;     ///< of its triangles, added up
  /// What the other mesh does not cover, heights differing by the tolerance at most.
  comparison::Areas uncovered;
};

struct MeshDescription {
  MeshPart whole;
  std::vector<MeshPart> layers;  ///< empty when the file has none
  std::size_t vertices = 0;      ///< of the file
  std::size_t positions = 0;     ///< different ones that triangles use
  std::size_t connections = 0, obstacleEdges = 0;
  double connectionLength = 0, obstacleEdgeLength = 0;
};

/// Two meshes compared. A is the ground truth where one is needed (thesis 5.5).
struct MeshComparison {
  std::array<MeshDescription, 2> meshes;
  comparison::SetDifference sets;
  double height = 0;
  double error = 0;
  /// A to B and B to A; none when a mesh is empty.
  std::optional<std::array<comparison::Distances, 2>> distances;

  /// Whether both are the same set of points, exactly: whatever their triangulation, winding and order.
  [[nodiscard]] bool equal() const { return !sets.hasArea[0] && !sets.hasArea[1]; }
  /// Share of A's surface that B covers within the height; 1 for an empty A.
  [[nodiscard]] double covered() const;
  /// Area of B over area of A: "walkable space covered" as thesis 5.5 computes it. None for an empty A.
  [[nodiscard]] std::optional<double> areaRatio() const;
};

/// Throws InputError for a height or error that is no finite number above or, for the height, at 0; Cancelled.
MeshComparison compareMeshes(const NavigationMesh& a, const NavigationMesh& b, const ComparisonOptions& options,
                             RunContext& context);

}  // namespace footfall::detail
