// Regions of walkable area over the borders of tiles: their areas, and which of them are too small.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/error_double.hpp"
#include "core/exact/grid.hpp"
#include "core/tiles/border_names.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile.hpp"

namespace footfall::detail {

/// The regions of a tile as far as it can find them alone (model, Area). Triangles that meet on a seam are of several
/// here, since a triangle of another tile may say that an obstacle stands there.
struct TileRegions {
  /// A side of a triangle of which other tiles have both ends.
  struct Seam {
    Index from = -1, to = -1;
    Index region = -1;
    bool isObstacle = false;
  };
  /// A link to or from a triangle of this tile where the other edge's first triangle is of another one; or both.
  struct Passage {
    std::size_t link = 0;
    Index region = -1;
  };
  std::vector<Index> regionOf;     ///< one region per triangle
  std::vector<ErrorDouble> areas;  ///< twice the area of each region, in scaled coordinates of the grid
  std::vector<Seam> seams;
  std::vector<Passage> passages;
};

/// `grid` is that of the whole environment.
TileRegions findTileRegions(const Tile& tile, const Grid& grid, Poll poll);

/// Regions of all tiles.
class RegionSums {
 public:
  explicit RegionSums(const Grid& grid) : grid_(grid) {}

  /// Tiles in their order, from 0 on.
  void add(const Tile& tile, const TileRegions& regions);

  /// Finds a tile again with its places, and calls inspect() with them.
  using Inspect = std::function<void(const Tile&, const ExactPlaceOf&)>;
  using FindAgain = std::function<void(std::size_t tile, const Inspect& inspect)>;
  /// One flag per region of each tile: it is larger than `minimum`, decided exactly as by AreaFilter. Call this once,
  /// when all tiles are there.
  std::vector<std::vector<char>> largerThan(double minimum, const FindAgain& findAgain, const Poll& poll);

 private:
  struct Edge {
    Index from = -1, to = -1;  ///< numbers of names, the smaller one first
    Index region = -1;
    bool isObstacle = false;
  };
  /// A link by the names of its vertices.
  struct Passage {
    std::array<Index, 4> ends{};
    Index region = -1;
  };
  [[nodiscard]] std::vector<Index> unite();
  [[nodiscard]] std::map<Index, std::vector<mpq_class>> rootsOf(const std::vector<Index>& rootOf,
                                                                const std::vector<char>& isDoubtful,
                                                                const FindAgain& findAgain, const Poll& poll) const;

  Grid grid_;
  BorderNames names_;
  std::vector<Edge> edges_;
  std::vector<Passage> passages_;
  std::vector<ErrorDouble> areas_;
  std::vector<std::size_t> first_{0};  ///< number of each tile's first region among all; then the number of all
};

/// A tile without the triangles of some regions, and the links that lead to no other one: `keeps` has one for each.
Tile withoutRegions(const Tile& tile, const std::vector<Index>& regionOf, const std::vector<char>& keeps);

}  // namespace footfall::detail
