// A folder of tiles with its index: what a run within a bound of memory leaves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/digest.hpp"
#include "core/tiles/tile.hpp"
#include "footfall/environment.hpp"
#include "footfall/geometry.hpp"
#include "footfall/run_context.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

inline constexpr const char* kTileIndex = "index.json";
/// The advice when files of a folder are damaged or missing.
inline constexpr Pattern kRunTilesAgain = FOOTFALL_TEXT("run `footfall run --memory` again");

struct TileEntry {
  std::string file;  ///< its name in the folder
  std::uint64_t faces = 0, triangles = 0, vertices = 0, borders = 0;
  std::uint64_t links = 0;  ///< those whose first triangle it has: each link is one of one tile
  Box box;                  ///< box of its vertices, Z up
  Digest::Value sum{};
};

/// Part `number`, from 1 on, of so many parts of an environment that are run by themselves.
struct TileSlice {
  std::uint32_t number = 1, count = 1;
};

struct TileSet {
  SourceFrame frame;
  Digest::Value environment{};  ///< PackedEnvironment::tableSum()
  bool bothSides = false;       ///< as in the run: an option may differ from the file
  std::vector<PartRole> roles;  ///< as in the run, one per part, or empty when all are floors
  TileSlice slice;
  std::string pipeline;         ///< formatPipeline()
  std::uint64_t triangles = 0;  ///< triangles of the environment
  std::vector<TileEntry> tiles;
};

/// The name of a tile by its number, from 1 on.
std::string tileFileName(std::size_t number);

/// Writes a tile as a file of the folder. Throws what writeFilesSafely() throws, and Cancelled.
TileEntry writeTile(const std::string& folder, const std::string& file, const Tile& tile, const RunContext& context);

/// JSON. The same set gives the same text.
std::string formatTileIndex(const TileSet& set);
/// True when a text begins as all indices do.
bool beginsAsTileIndex(std::string_view text);

/// Throws InputError "PATH: what; what to do" where the folder has no index or it is none, and Cancelled.
TileSet readTileIndex(const std::string& folder, RunContext* context);

/// Throws InputError where the file is missing, damaged, or not the one that the index has.
Tile readTile(const std::string& folder, const TileEntry& entry, RunContext* context);

}  // namespace footfall::detail
