// Running a pipeline of local filters over an environment that no memory need hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/distributed/rank_group.hpp"
#include "core/io/packed/packed_environment.hpp"
#include "core/tiles/cell_outcome.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile_set.hpp"
#include "core/tiles/tile_store.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The number of progress steps of a run. Cells count in order; each adds its share of the triangles.
inline constexpr std::size_t kTileRunSteps = 1000;

struct TileRunOptions {
  std::uint64_t memory = 0;         ///< bytes that the process may hold at once
  std::uint64_t mostFaces = ~0ULL;  ///< the most faces of the environment that a cell has for itself; tests make it
                                    ///< small
  TileSlice slice{};                ///< part of the environment that runs alone
  std::vector<PartRole> roles{};    ///< one role per Environment::parts (rolesOf()); empty: all are floors
  /// Receives notes for the user on rank 0, before the first cell runs; may be empty.
  std::function<void(const Text&)> note{};
};

/// The figures of one rank.
struct TileRankStatistics {
  CellCounts counts;
  std::uint64_t bytesRead = 0;  ///< bytes of the packed environment
  std::uint64_t peakBytes = 0;  ///< peak of the process
  double wallMs = 0, cpuMs = 0;
};

struct TileRunResult {
  TileSet set;
  CellCounts counts;                      ///< sum over all ranks
  std::vector<TileRankStatistics> ranks;  ///< one entry per rank
  double wallMs = 0, cpuMs = 0;
};

/// Throws InputError where a step needs all slices.
void checkSlice(const CellSteps& steps, const TileSlice& slice);

/// Runs the pipeline cell by cell, and adds a tile for each that has triangles. As runIntoTiles() else; the set of the
/// result has no tiles.
TileRunResult runCells(const PackedEnvironment& environment, const Pipeline& pipeline, const TileRunOptions& options,
                       TileStore& store, RankGroup& ranks, RunContext& context);

/// Runs the pipeline cell by cell and writes a tile for each into `folder`, which must be there, and empty unless a
/// run of the same did not end there, then the index. Cells follow the order of the packed environment's blocks, and
/// are as large as the memory lets them be by what is known before they run; so the same environment, pipeline and
/// options give the same bytes, whatever the threads and however many ranks.
///
/// All ranks call it, with the same environment, pipeline and options and a folder that all of them see. They share the
/// cells; what comes behind them is done by rank 0, whose result is the whole one. That of others has statistics only.
///
/// Throws InputError where a filter cannot keep to a bound of memory or see over slices, and where the bound is too
/// little, with what it must be; RunError as writeFileSafely() does and where ranks were given different things, and
/// Cancelled. Then what was written is removed; with several ranks it stays for removeUnfinished(), or for a run that
/// goes on from there, with any number of ranks: so does the folder of a run that was killed. What was found there when
/// the run began stays, too.
TileRunResult runIntoTiles(const PackedEnvironment& environment, const Pipeline& pipeline, const std::string& folder,
                           const TileRunOptions& options, RankGroup& ranks, RunContext& context);

}  // namespace footfall::detail
