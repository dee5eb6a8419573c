// The cells of a partition, as a table and as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/partitioning/partition.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// The counts of cutting the environment along the cells.
struct CutCounts {
  std::uint64_t vertices = 0;
  std::uint64_t cutVertices = 0;  ///< vertices made by cuts
  std::uint64_t triangles = 0;
  std::uint64_t closedTriangles = 0;  ///< triangles left out because rounding merged their corners
};

struct CellsReport {
  const Environment& environment;
  const Partition& partition;
  int threads = 1;  ///< threads over which the cells are spread, largest first
  std::optional<CutCounts> cut;
};

/// A table for people: a row for each cell (its rectangle and heights in the file's frame and units, the floors and
/// obstacles in it, the estimated cost), then the strategy, why it was picked, and how even the cells are.
std::string formatCells(const CellsReport& report);

/// The table's numbers as JSON. Sides that are open are null.
std::string formatCellsJson(const CellsReport& report);

}  // namespace footfall::detail
