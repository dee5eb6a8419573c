// One generation of source geometry: distinct vertices and triangles in an order of their own, ready for exact work.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices are sorted by x, y, z and welded; triangles start at their smallest vertex and are sorted by their vertices.
// Results therefore cannot depend on the order of the input (model, The same answer): the first element in a fixed
// geometric order is the one with the smaller index.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/base/poll.hpp"
#include "core/base/shared_array.hpp"
#include "core/exact/error_double.hpp"
#include "core/exact/grid.hpp"
#include "core/exact/source_tree.hpp"

namespace footfall::detail {

struct SourceEdit;  // core/exact/source_edit.hpp

struct SourceMesh {
  std::vector<Vec3> vertices;
  /// Coordinates times 2^grid.scaleExponent(): what doubles compute with. Exact, except where a coordinate underflows,
  /// which the sign rule allows for.
  std::vector<Vec3> scaled;
  /// The plan id of each vertex: the smallest vertex with the same x and y, its identity in the plan.
  std::vector<Index> planIds;
  // Copies to which places of the plan are added share what belongs to triangles.
  SharedArray<std::array<Index, 3>> triangles;
  SharedArray<std::uint32_t> inputTriangles;           ///< index in the environment (or in the earlier generation)
  SharedArray<std::array<ErrorDouble, 3>> normals;     ///< scaled; zero components are exactly zero
  SharedArray<std::int8_t> facing;                     ///< sign of the normal's z
  SharedArray<char> degenerate;                        ///< zero area
  std::vector<std::pair<Index, Index>> obstacleEdges;  ///< those of an earlier generation: sorted, smaller vertex first

  Grid grid;  ///< the vertices' grid

  SourceTree tree;  ///< all triangles that are not degenerate

  SharedArray<Index> welded;               ///< welded vertex of each vertex of the soup
  std::shared_ptr<const SourceEdit> edit;  ///< its relation to an earlier mesh; null when it was made from nothing
  std::vector<char> addedLater;            ///< one flag per triangle: edits since the tree was built added it; or empty

  /// The number of vertices at the end that are no corners of triangles, only places of the plan (addPlanPlaces()).
  std::size_t planPlaces = 0;
  /// The mesh without those places, where another one of the same vertices and triangles may be compared with it; or
  /// null.
  std::shared_ptr<const SourceMesh> withoutPlaces;

  [[nodiscard]] bool hasObstacleEdge(Index a, Index b) const;
};

/// A view of vertices and triangles that lie elsewhere, with facts about them. The viewed data must outlive it.
struct SoupView {
  std::span<const Vec3> vertices;
  std::span<const Triangle> triangles;
  std::span<const std::uint32_t> inputTriangles;  ///< number in the input of each triangle; empty: 0, 1, 2, ...
  std::span<const std::array<std::uint32_t, 2>> obstacleEdges = {};  ///< pairs of vertices on which obstacles stand
  Grid grid = {};  ///< grid of the whole that this is a part of, so that results are the same as in the whole

  SoupView(std::span<const Vec3> givenVertices, std::span<const Triangle> givenTriangles,
           std::span<const std::uint32_t> givenInputTriangles = {})
      : vertices(givenVertices), triangles(givenTriangles), inputTriangles(givenInputTriangles) {}
  SoupView(const TriangleSoup& soup)  // NOLINT(google-explicit-constructor)
      : SoupView(soup.vertices, soup.triangles) {}
};

// The steps of makeSourceMesh() that an edit repeats for what is new.

[[nodiscard]] inline Vec3 withoutNegativeZeros(const Vec3& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }
/// Order of vertices: x, y, z.
[[nodiscard]] inline bool isBefore(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}
/// A triangle of the soup that starts at its smallest vertex.
std::array<Index, 3> turnedTriangle(const SourceMesh& mesh, const Triangle& triangle, bool bothSides);
/// Finds the grid, of the vertices and what it has already, and the scaled coordinates of the vertices.
void chooseGrid(SourceMesh& mesh, Poll poll);
/// The box of a triangle.
[[nodiscard]] Box boxOf(const SourceMesh& mesh, Index triangle);
/// Builds the tree over all triangles that are not degenerate.
void buildTree(SourceMesh& mesh, Poll poll);
/// Adds vertices that are places of the plan only, multiples of 2^-17 in scaled coordinates and below 2^36 in size, and
/// returns their plan ids. What was made of the mesh before stays good.
std::vector<Index> addPlanPlaces(SourceMesh& mesh, std::span<const Vec3> scaled);
/// Finds normal, facing and degeneracy of a triangle.
void classifyTriangle(SourceMesh& mesh, Index triangle, const SignRule& sign);

/// Welds, sorts and classifies, in parallel where there is much to do. `bothSides` turns triangles that face down.
/// `order` (may be null) receives for each triangle of the mesh its number in the soup. `poll` is called every few
/// milliseconds, by any thread, and may throw to cancel.
SourceMesh makeSourceMesh(const SoupView& soup, bool bothSides, std::vector<std::uint32_t>* order = nullptr,
                          Poll poll = {});

}  // namespace footfall::detail
