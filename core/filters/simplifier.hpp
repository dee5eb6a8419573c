// Taking away the vertices of a walkable mesh that its outline does not need.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices go one by one: those inside a coplanar region, and those in the middle of a straight piece of its outline.
// The hole around a vertex is star-shaped, so ears can be cut off it by looking at three corners only (O. Devillers,
// "On deletion in Delaunay triangulations", 1999). What is left has no vertex that could go, and the number of
// triangles follows from Euler's formula. A last pass flips edges inside regions towards Delaunay.
#pragma once

#include <array>
#include <vector>

#include "core/filters/mesh_geometry.hpp"
#include "core/pipeline/run_context.hpp"

namespace footfall {

/// When triangles count as coplanar although they are not, and what that may cost.
struct ApproximateSimplification {
  bool enabled = false;
  double tolerance = 0;  ///< coplanar where the dot product of unit normals exceeds 1 - tolerance (thesis 5.1.2)
  double bound = 0;      ///< nothing taken away is farther than this from what replaces it; scaled units
};

class Simplifier {
 public:
  /// Exact unless `approximate` says otherwise.
  Simplifier(const PlanKernel& kernel, const WalkableMesh& mesh, const ApproximateSimplification& approximate,
             RunContext& context)
      : kernel_(kernel), approximate_(approximate), context_(context), geometry_(kernel, mesh.vertices), mesh_(mesh) {}

  WalkableMesh run();

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return geometry_.fallbacks; }

 private:
  /// The triangles at a vertex between two outline edges, or all around it.
  struct Fan {
    std::vector<Index> triangles;
    std::vector<Index> ring;  ///< opposite vertices, counter-clockwise; a closed fan does not repeat the first
    bool closed = false;
    int firstFlag = 0, lastFlag = 0;   ///< obstacle flags of the first and the last outline edge
    std::vector<Index> ringNeighbors;  ///< for each ring edge the side beyond it, or -1
    std::vector<int> ringFlags;        ///< and its obstacle flag
  };
  using Corners = std::array<Index, 3>;

  void findInnerEdges();
  [[nodiscard]] bool mayJoin(Index face, Index other);
  [[nodiscard]] int cornerOf(Index triangle, Index vertex) const;
  void collectFans(Index vertex);
  void removeIfPossible(Index vertex);
  [[nodiscard]] bool isStraight(Index u, Index v, Index w);
  bool turnsOnce(Index vertex, const Fan& fan);
  /// Triangles of a fan's ring without its vertex; false when none was found.
  bool cutEars(Index vertex, const Fan& fan, std::vector<Corners>& result);
  bool cutAnyEars(const Fan& fan, std::vector<Corners>& result);
  /// Nothing that the fans stood for is farther than the bound from the new triangles; collects it.
  bool isWithinBound(Index vertex, const std::vector<std::vector<Corners>>& filled, std::vector<Index>& stoodFor);
  void replace(const Fan& fan, const std::vector<Corners>& corners);
  void improve();
  bool flipIfBetter(Index side);
  WalkableMesh compact();

  const PlanKernel& kernel_;
  ApproximateSimplification approximate_;
  RunContext& context_;
  MeshGeometry geometry_;
  WalkableMesh mesh_;
  std::vector<Index> neighbors_;  ///< for each side the side on the other triangle of its region, or -1
  std::vector<std::vector<Index>> around_;
  std::vector<std::vector<Index>> standsFor_;  ///< approximate mode: vertices taken away at each triangle
  std::vector<char> alive_;
  std::vector<Fan> fans_;
};

}  // namespace footfall
