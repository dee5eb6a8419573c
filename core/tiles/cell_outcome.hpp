// The outcome of a cell, as sent from rank to rank.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/tiles/cell_faces.hpp"

namespace footfall::detail {

/// A cell of a plan that ran, in one piece or, where it did not fit, in several.
struct CellOutcome {
  struct Piece {
    FaceRange range;
    std::string written;  ///< TileStore::write() of its tile; empty where the piece has no triangles
  };
  std::size_t cell = 0;  ///< its number in the plan
  std::vector<Piece> pieces;
  FloorsAtGaps atGaps;
};

/// The figures of cells, for one rank or for all.
struct CellCounts {
  std::uint64_t cells = 0;        ///< number of cells that ran, including those without a walkable place
  std::uint64_t largestCell = 0;  ///< triangles that were in memory at once
  std::uint64_t collected = 0;    ///< triangles of all cells together: neighbours have some in common
  std::uint64_t refused = 0;      ///< cells that were made smaller because they would not have fitted
  std::uint64_t takenOver = 0;    ///< cells of a run that was killed, besides

  void add(const CellCounts& others);
};

std::string encodeOutcomes(const std::vector<CellOutcome>& outcomes, const CellCounts& counts);
/// Adds to both. Throws BadBytes.
void decodeOutcomes(std::string_view bytes, std::vector<CellOutcome>& outcomes, CellCounts& counts);

}  // namespace footfall::detail
