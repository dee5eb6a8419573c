// Taking away vertices inside one group of coplanar regions; the work of one thread of a Simplifier.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hole around a vertex is star-shaped, so ears can be cut off it by looking at three corners only (O. Devillers,
// "On deletion in Delaunay triangulations", 1999).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/corner_lists.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// The condition under which triangles count as coplanar although they are not, and the allowed error.
struct ApproximateSimplification {
  bool enabled = false;
  double tolerance = 0;  ///< coplanar where the dot product of unit normals exceeds 1 - tolerance (thesis 5.1.2)
  double bound = 0;      ///< nothing taken away is farther than this from what replaces it; scaled units
};

/// The data that all groups work on, each on its own triangles.
struct SimplifiedMesh {
  const std::vector<MeshVertex>& vertices;
  std::vector<MeshTriangle> triangles;
  std::vector<Index> neighbors;  ///< side on the other triangle of its region, of each side, or -1
  std::vector<char> alive;
  CornerLists around;                         ///< triangles around the vertices that may go
  std::vector<std::vector<Index>> standsFor;  ///< approximate mode: vertices taken away at each triangle
};

/// Simplifies one group of triangles after another; one object for each thread.
class RegionSimplifier {
 public:
  RegionSimplifier(const PlanKernel& kernel, SimplifiedMesh& mesh, const ApproximateSimplification& approximate,
                   Poll poll)
      : mesh_(mesh), approximate_(approximate), poll_(poll), geometry_(kernel, mesh.vertices) {}

  /// Takes away what can go of `vertices` (in the order of their first use by `triangles`, so that no number matters;
  /// all their triangles must be in the group, and exactly, each must be inside a region or in the middle of a straight
  /// piece of outline), then flips edges inside the regions of `triangles` (ascending) towards Delaunay.
  void simplify(std::span<const Index> vertices, std::span<const Index> triangles);

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return geometry_.fallbacks; }

 private:
  /// The triangles at a vertex between two outline edges, or all around it, and the hole that they leave.
  struct Fan {
    std::vector<Index> triangles;
    std::vector<Index> ring;          ///< opposite vertices, counter-clockwise; a closed fan does not repeat the first
    std::vector<Index> beyond;        ///< side beyond each ring edge, or -1
    std::vector<std::uint8_t> flags;  ///< and its obstacle flag; for an open fan the last edge is the new outline
    std::vector<std::array<Index, 3>> ears;  ///< the triangles that fill the hole, as places in the ring
    bool closed = false;
    int firstFlag = 0, lastFlag = 0;  ///< obstacle flags of the first and the last outline edge
  };

  [[nodiscard]] int cornerOf(Index triangle, Index vertex) const;
  /// Lists the triangles at a vertex.
  void collectTriangles(Index vertex);
  /// Divides what collectTriangles() has listed into fans.
  void collectFans(Index vertex);
  void collectFan(Index vertex, Index start, Fan& fan) const;
  /// Call collectTriangles() first.
  void removeIfPossible(Index vertex);
  [[nodiscard]] bool isStraight(Index u, Index v, Index w) const;
  bool turnsOnce(Index vertex, const Fan& fan);
  void linkRing(const Fan& fan);
  void unlink(Index place);
  /// Finds the ears of a fan's hole; false when there are none.
  bool cutEars(Index vertex, Fan& fan);
  bool cutAnyEars(Fan& fan);
  /// Returns whether nothing that the fans stood for is farther than the bound from the new triangles; collects it.
  bool isWithinBound(Index vertex, std::vector<Index>& stoodFor);
  void replace(Fan& fan);
  void improve(std::span<const Index> triangles);
  bool flipIfBetter(Index side);

  SimplifiedMesh& mesh_;
  const ApproximateSimplification& approximate_;
  Poll poll_;
  MeshGeometry geometry_;
  std::vector<Fan> fans_;  ///< only the first fanCount_ are in use: their memory is kept
  std::size_t fanCount_ = 0;
  std::vector<Index> at_;  ///< triangles at a vertex
  std::vector<char> seen_;
  std::vector<Index> ringNext_, ringPrevious_;
  std::vector<Index> queue_;
};

}  // namespace footfall::detail
