// One navigation mesh of a folder of tiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/tiles/tile_set.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

class TileGathering;  // core/tiles/tile_gathering.hpp

/// Puts tiles together, in any order.
class TileJoiner {
 public:
  TileJoiner();
  ~TileJoiner();
  TileJoiner(const TileJoiner&) = delete;
  TileJoiner& operator=(const TileJoiner&) = delete;

  /// Throws RunError where there are more triangles than numbers. `poll` is called now and then and may throw to
  /// cancel.
  void add(const Tile& tile, const Poll& poll = {});
  /// The mesh that a run with all of the environment in memory has, to the last bit; the frame is left empty. To be
  /// called once. Throws BadBytes where tiles do not belong together.
  std::shared_ptr<NavigationMesh> join(RunContext& context);

 private:
  std::unique_ptr<TileGathering> gathering_;
};

struct JoinedTiles {
  std::vector<TileSet> sets;  ///< one set per folder
  std::shared_ptr<const NavigationMesh> mesh;
};

/// Joins all tiles of the folders, which are the slices of one environment: holds the result, and nothing of the
/// environment. Throws InputError as readTileIndex() and readTile() do and where the folders are not all slices of one
/// run, RunError as TileJoiner, and Cancelled.
JoinedTiles joinTiles(std::span<const std::string> folders, RunContext& context);

}  // namespace footfall::detail
