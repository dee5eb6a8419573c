// Triangles of several tiles as one exact mesh, as far as they go: for filters that decide over the borders of tiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/exact/grid.hpp"
#include "core/tiles/tile.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// A mesh with the kernel of what its vertices are made of. Numbers of vertices, triangles and faces ascend as those of
/// the whole, and all approximations are the same as there.
class TileUnion {
 public:
  /// One tile with geometry, or some triangles of one.
  struct Part {
    std::size_t tile = 0;  ///< whatever the caller numbers them by
    Tile triangles;
    std::vector<Index> numbers{};  ///< number in the tile of each triangle; empty: it is the whole tile
    std::vector<char> isOwn{};     ///< one flag per triangle; empty: all are own
    std::vector<char> isLinked{};  ///< one flag per vertex: it is an end of a link; or empty
  };
  struct Origin {
    std::uint32_t part = 0;
    Index number = -1;  ///< number in the part
  };

  /// `grid` is that of the whole environment. No two parts are of one tile.
  TileUnion(std::vector<Part> parts, const Grid& grid, RunContext& context);

  [[nodiscard]] const PlanKernel& kernel() const { return *kernel_; }
  /// Vertices that are ends of links are marked by a link from the vertex to itself.
  [[nodiscard]] const WalkableMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Part& partOf(Index triangle) const { return parts_[triangles_[triangle].part]; }
  [[nodiscard]] const Tile& firstPart() const { return parts_.front().triangles; }
  [[nodiscard]] bool isOwn(Index triangle) const;
  /// The vertex of the mesh that a vertex of a part is.
  [[nodiscard]] Index vertexOfPart(std::size_t part, Index vertex) const { return numbers_[part][vertex]; }
  /// The name of the vertex for other tiles.
  [[nodiscard]] TileOutside outsideOf(Index vertex) const;
  /// The triangle's number in its tile.
  [[nodiscard]] Index numberInTile(Index triangle) const;

  /// A changed triangle of the mesh, with its place in the order of all.
  struct Changed {
    Index triangle = -1;
    MeshTriangle now;
  };
  /// A tile of these (ascending). Vertices that had names keep them, and those of which `isNamed` is not 0 get one.
  [[nodiscard]] Tile tileOf(std::span<const Changed> triangles, const std::vector<char>& isNamed) const;

 private:
  void makeKernel(const Grid& grid, RunContext& context);
  void addMesh(RunContext& context);
  [[nodiscard]] MeshVertex vertexOf(const Origin& origin) const;
  [[nodiscard]] const TileBorder* borderAt(const Origin& vertex) const;
  [[nodiscard]] Index faceOf(Index triangle) const;
  void addVertex(Index vertex, bool isNamed, Tile& tile) const;

  std::vector<Part> parts_;
  std::shared_ptr<const PlanKernel> kernel_;
  WalkableMesh mesh_;
  /// The numbers of the faces, and of the geometry's triangles and corners, of each part in the kernel's mesh.
  std::vector<std::vector<Index>> faces_, sources_, corners_;
  std::vector<Origin> triangles_, vertices_;  ///< origins of the mesh's triangles and vertices
  std::vector<std::vector<Index>> numbers_;   ///< numbers of each part's vertices in the mesh
};

}  // namespace footfall::detail
