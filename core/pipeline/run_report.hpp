// What a run tells about its time: phases as in the thesis (5.4), and every cell of every parallel block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/partitioning/partition.hpp"
#include "core/text.hpp"

namespace footfall {

/// One filter at work on one cell, on one thread, without a break. Times are milliseconds since the run began.
struct CellSpan {
  std::string filter;
  int thread = 0;  ///< 0 to threads - 1
  double startMs = 0;
  double endMs = 0;
};

struct CellReport {
  CellBounds bounds;
  double cost = 0;                 ///< estimated before the run, in units of one trivial triangle
  std::uint64_t trianglesIn = 0;   ///< floors (or their pieces) and the obstacles that may matter to them
  std::uint64_t trianglesOut = 0;  ///< walkable triangles that its filters left
  int thread = 0;                  ///< that began it
  double startMs = 0;              ///< since the run began
  double endMs = 0;
  /// In order of time. Idle threads may help with a cell, so spans can be on several threads.
  std::vector<CellSpan> spans;

  /// Time that threads spent on the cell: the sum of its spans.
  [[nodiscard]] double workMs() const;
};

/// A parallel block: from a strategy to Collapse.
struct BlockReport {
  std::size_t firstStep = 0;  ///< the strategy's, among the enabled steps
  std::size_t lastStep = 0;   ///< Collapse's
  std::string strategy;       ///< that made the cells, with its parameters
  Text reason;                ///< why, where Auto picked it; else empty
  double startMs = 0;         ///< since the run began
  double partitioningMs = 0;
  double parallelMs = 0;
  double mergingMs = 0;
  std::vector<CellReport> cells;
  /// Filters of the block that worked on the whole environment, after its cells were put together.
  std::vector<CellSpan> shared;

  /// Time that each thread spent on cells.
  [[nodiscard]] std::vector<double> busyMs(int threads) const;
  /// Load imbalance: the largest thread's time over the mean; 1 when nothing was done.
  [[nodiscard]] double imbalance(int threads) const;
};

/// Where the time of a run went (thesis 5.4), in milliseconds. Without a block, all filters are pre-processing.
struct RunTimes {
  double preprocessing = 0;  ///< filters before the first block (and between blocks)
  double partitioning = 0;   ///< all blocks together, as the next two
  double parallel = 0;
  double merging = 0;
  double postprocessing = 0;  ///< filters after the last block
  double overhead = 0;        ///< the rest: first state, navigation mesh, book-keeping
  double total = 0;
};

}  // namespace footfall
