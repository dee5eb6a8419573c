// The interface to tiles that a run does not hold in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "core/tiles/tile.hpp"

namespace footfall::detail {

/// The place where the tiles of a run are kept, numbered from 0 on.
class TileStore {
 public:
  TileStore() = default;
  virtual ~TileStore() = default;
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  virtual void add(const Tile& tile) = 0;
  virtual Tile read(std::size_t number) = 0;
  /// Replaces a tile by one that has less of it, or nothing.
  virtual void replace(std::size_t number, const Tile& tile) = 0;

  /// Writes a tile that has no number yet, under a name that no other has. Returns what take() is to be given, by this
  /// process or by another one that has the same store; never empty.
  virtual std::string write(const std::string& name, const Tile& tile) = 0;
  /// Makes a written tile the one of that number; that of the first one behind all others adds it.
  virtual void take(std::size_t number, const std::string& written) = 0;

  // The outcomes of cells in a store that outlives a killed run:

  /// Called by rank 0 before all others. True when there is something of an earlier run with the same `what`, which
  /// identifies it. Throws InputError when there is something else.
  virtual bool begin(const std::string& /*what*/) { return false; }
  /// All ranks: there is. What is there stays when this run fails.
  virtual void goOn() {}
  virtual void keepCell(const std::string& /*name*/, const std::string& /*bytes*/) {}
  /// Empty where there is none.
  virtual std::string keptCell(const std::string& /*name*/) { return {}; }
  /// True when a tile of an earlier run is whole.
  virtual bool has(const std::string& /*written*/) { return false; }
};

}  // namespace footfall::detail
