// Where a run keeps tiles that it does not hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/tiles/tile.hpp"

namespace footfall::detail {

/// Where the tiles of a run are kept, numbered from 0 on.
class TileStore {
 public:
  TileStore() = default;
  virtual ~TileStore() = default;
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  virtual void add(const Tile& tile) = 0;
  virtual Tile read(std::size_t number) = 0;
  /// By one that has less of it, or nothing.
  virtual void replace(std::size_t number, const Tile& tile) = 0;
};

}  // namespace footfall::detail
