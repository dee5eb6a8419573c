// Triangles of tiles in the order in which the whole environment has them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/filters/rounding/placed_mesh.hpp"
#include "core/tiles/border_names.hpp"
#include "core/tiles/tile.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Collects tiles, in any order.
class TileGathering {
 public:
  /// Throws RunError where there are more triangles than numbers. `poll` is called now and then and may throw to
  /// cancel.
  void add(const Tile& tile, const Poll& poll);

  struct Whole {
    /// Triangles in the order of their faces; vertices in the order of their first use.
    PlacedMesh mesh;
    std::vector<Index> addedAs;   ///< number of each triangle in the order of addition
    std::vector<double> heights;  ///< MeshVertex::z of the vertices; empty unless all tiles had geometry
  };
  /// Call this once. Throws BadBytes when only some tiles have layers, or layers are out of range.
  Whole take(RunContext& context);

 private:
  /// A face of some tile, with the place of its triangles among all that were added.
  struct AddedFace {
    TileFace face;
    std::size_t firstTriangle = 0;
  };

  std::vector<Index> numberVertices(const Tile& tile, const Poll& poll);
  void addLinks(const Tile& tile, std::vector<Index>& numbers, const Poll& poll);
  void addTriangle(std::size_t added, Whole& whole);
  [[nodiscard]] std::uint32_t numberOf(std::size_t triangle) const;

  std::vector<AddedFace> faces_;
  std::vector<MeshTriangle> triangles_;  ///< `face`: the number in the environment of the one in whose plane it lies
  std::vector<std::uint32_t> numbers_;   ///< number of each triangle within its face; empty: unknown
  std::vector<std::uint32_t> layers_;
  std::vector<Vec3> places_;
  std::vector<char> exact_;
  std::vector<double> heights_;
  std::vector<MeshLink> links_;
  BorderNames borders_;
  std::vector<Index> renumbered_;
};

}  // namespace footfall::detail
