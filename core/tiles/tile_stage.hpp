// Tiles between filters that see over their borders, and how much of them may be in memory at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/exact/grid.hpp"
#include "core/tiles/tile_store.hpp"
#include "core/tiles/tile_union.hpp"
#include "footfall/geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The bytes of a triangle in a TileUnion while a filter works on it.
inline constexpr std::uint64_t kOfUnionTriangle = 1500;
/// The bytes of a triangle while layers are chosen, and of a pair that overlaps.
inline constexpr std::uint64_t kOfLayerTriangle = 400, kOfLayerPair = 48;
/// The numbers of overlapping pairs of a triangle, at a guess, as in a city (4.7) and in low levels: only messages
/// about too little memory depend on them, until the pairs are counted.
inline constexpr std::uint64_t kUsualPairs = 5, kFewPairs = 3;

/// A box around what rounds to these places.
Box boxAround(std::span<const Vec3> places);

/// A tile of a store.
struct StoredTile {
  std::size_t number = 0;
  std::uint64_t triangles = 0;
  Box box;  ///< box of its vertices, not of their rounded places
};

StoredTile storedTileOf(std::size_t number, const Tile& tile);

/// The tiles of a run, all with geometry.
struct TileStage {
  TileStore& store;
  std::size_t count = 0;          ///< number of tiles that the store was given
  std::vector<StoredTile> tiles;  ///< tiles in use
  Grid grid;                      ///< grid of the whole environment
  std::uint64_t memory = 0;       ///< bytes for triangles at once
  /// Throws what says that so many bytes are needed in its place.
  std::function<void(std::uint64_t needed)> failTooLittle;

  /// Stores a tile, unless it is empty.
  void add(const Tile& tile, std::vector<StoredTile>& to);
  void require(std::uint64_t bytes) const { require(bytes, bytes); }
  /// The same, with the bytes that the message names: an estimate of what all of the step needs.
  void require(std::uint64_t bytes, std::uint64_t expected) const {
    if (bytes > memory) failTooLittle(std::max(bytes, expected));
  }
};

bool touch(const Box& a, const Box& b);
bool touchInPlan(const Box& a, const Box& b);

/// Each coplanar region with as few triangles as its outline needs (SimplificationFilter, exactly): regions within a
/// tile by themselves, those over borders together, in tiles of their own.
void simplifyTiles(TileStage& stage, RunContext& context);

/// Gives each triangle its layer (LayerSubdivisionFilter).
void layTiles(TileStage& stage, RunContext& context);

}  // namespace footfall::detail
