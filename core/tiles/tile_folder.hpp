// Tiles of a run in files of one folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/tiles/tile_set.hpp"
#include "core/tiles/tile_store.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Removes what this process has written unless the run ends well. Its functions throw what writeFilesSafely() and
/// readTile() throw, and Cancelled.
class TileFolder : public TileStore {
 public:
  TileFolder(const std::string& folder, RunContext& context) : folder_(folder), context_(context) {}
  ~TileFolder() override;

  void add(const Tile& tile) override;
  Tile read(std::size_t number) override { return readTile(folder_, entries_[number], &context_); }
  void replace(std::size_t number, const Tile& tile) override;
  std::string write(const std::string& name, const Tile& tile) override;
  void take(std::size_t number, const std::string& written) override;

  /// Leaves the folder with its index.
  void finish(TileSet& set);
  /// Another process has taken what this one wrote, and left the folder with its index.
  void keep() { written_.clear(); }

 private:
  void remember(const TileEntry& entry) { written_.push_back(entry.file); }

  std::string folder_;
  RunContext& context_;
  std::vector<std::string> written_;
  std::vector<TileEntry> entries_;
};

}  // namespace footfall::detail
