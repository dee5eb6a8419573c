// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_join.hpp"

#include <algorithm>
#include <utility>

#include "core/base/byte_stream.hpp"
#include "core/filters/rounding/placed_mesh.hpp"
#include "core/io/input_file.hpp"
#include "core/tiles/tile_gathering.hpp"

namespace footfall::detail {
TileJoiner::TileJoiner() : gathering_(std::make_unique<TileGathering>()) {}
TileJoiner::~TileJoiner() = default;

void TileJoiner::add(const Tile& tile, const Poll& poll) { gathering_->add(tile, poll); }

std::shared_ptr<NavigationMesh> TileJoiner::join(RunContext& context) {
  const PlacedMesh mesh = std::exchange(gathering_, nullptr)->take(context).mesh;
  return makeNavigationMesh(mesh, context);
}

namespace {

// Each slice once, all of one environment and pipeline.
void checkSlices(std::span<const std::string> folders, const std::vector<TileSet>& sets) {
  const TileSet& first = sets.front();
  std::vector<char> isThere(sets.size(), 0);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const TileSet& set = sets[i];
    if (set.environment != first.environment || set.pipeline != first.pipeline || set.bothSides != first.bothSides ||
        set.roles != first.roles || set.slice.count != first.slice.count || set.frame.up != first.frame.up ||
        set.frame.metresPerUnit != first.frame.metresPerUnit)
      throw InputError(
          FOOTFALL_TEXT("%1 and %2 are tiles of different environments, pipelines or slices; give folders of one "
                        "run"),
          folders.front(), folders[i]);
    if (set.slice.number > sets.size() || std::exchange(isThere[set.slice.number - 1], 1) != 0 ||
        set.slice.count != sets.size())
      throw InputError(
          FOOTFALL_TEXT("%1 is slice %2 of %3, and the folders given are not all of them, each once; give all"),
          folders[i], set.slice.number, set.slice.count);
  }
}

}  // namespace

JoinedTiles joinTiles(std::span<const std::string> folders, RunContext& context) {
  JoinedTiles joined;
  std::size_t tiles = 0, added = 0;
  for (const std::string& folder : folders) {
    joined.sets.push_back(readTileIndex(folder, &context));
    tiles += joined.sets.back().tiles.size();
  }
  checkSlices(folders, joined.sets);
  TileJoiner joiner;
  std::shared_ptr<NavigationMesh> mesh;
  std::size_t folder = 0;
  try {
    for (; folder < folders.size(); ++folder)
      for (const TileEntry& entry : joined.sets[folder].tiles) {
        context.checkCancelled();
        joiner.add(readTile(folders[folder], entry, &context), context);
        context.progress(0.5 * static_cast<double>(++added) / static_cast<double>(tiles));
      }
    mesh = joiner.join(context);
  } catch (const BadBytes& error) {
    failInput(folders[std::min(folder, folders.size() - 1)], 0, error.what(), kRunTilesAgain);
  }
  mesh->frame = joined.sets.front().frame;
  joined.mesh = mesh;
  return joined;
}

}  // namespace footfall::detail
