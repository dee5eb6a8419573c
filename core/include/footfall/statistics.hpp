// The statistics of a run: what each step did, its time, phases as in the thesis (5.4), and every cell of every
// parallel block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "footfall/text.hpp"

namespace footfall {

/// The decisions that doubles could not take and exact arithmetic had to, by kind.
struct ExactFallbacks {
  std::uint64_t slope = 0, height = 0, orientation = 0, side = 0, order = 0, area = 0;
  [[nodiscard]] std::uint64_t total() const { return slope + height + orientation + side + order + area; }
  ExactFallbacks& operator+=(const ExactFallbacks& o) {
    slope += o.slope;
    height += o.height;
    orientation += o.orientation;
    side += o.side;
    order += o.order;
    area += o.area;
    return *this;
  }
};

/// The state of a pipeline after one of its steps.
struct StateSummary {
  std::uint64_t triangles = 0;  ///< walkable triangles
  double area = 0;              ///< 3D surface area of the walkable triangles, rounded
  std::uint64_t rejected = 0;   ///< triangles of the environment that are obstacles only
  std::uint32_t layers = 0;
  std::uint64_t connections = 0;
  std::uint64_t obstacleEdges = 0;
  std::uint64_t links = 0;  ///< steps, as pairs of edges
  std::uint64_t drops = 0;  ///< stretches of border from which one drops
};

/// One step of a run: what it had, what it left, and what that took.
struct StepStatistics {
  std::string name;
  std::vector<double> parameters;
  double startMs = 0;  ///< since the run began; the filters of a parallel block begin together
  double wallMs = 0;   ///< inside a parallel block: the filter's share of the time that its cells took
  double cpuMs = 0;    ///< processor time of the whole process while the step ran; inside a parallel block: of all
                       ///< threads on cells
  bool fromCache = false;
  StateSummary in, out;
  Text note;
  ExactFallbacks fallbacks;
};

/// A half-open box: [lower, upper) in x and y; floors whose lowest corner lies in [lower, upper) in z. Units of the
/// environment; infinite on the outer sides.
struct CellBounds {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lower{-kInfinity, -kInfinity, -kInfinity};
  std::array<double, 3> upper{kInfinity, kInfinity, kInfinity};
  /// Numbers of the cuts that are its sides in x and y; -1 on an outer side.
  std::array<std::int32_t, 2> lowerBorder{-1, -1};
  std::array<std::int32_t, 2> upperBorder{-1, -1};
};

/// One filter at work on one cell, on one thread, without a break. Times are milliseconds since the run began.
struct CellSpan {
  std::string filter;
  int thread = 0;  ///< 0 to threads - 1
  double startMs = 0;
  double endMs = 0;
};

/// One cell of a parallel block.
struct CellReport {
  CellBounds bounds;
  double cost = 0;                 ///< estimated before the run, in units of one trivial triangle
  std::uint64_t trianglesIn = 0;   ///< floors (or their pieces) and the obstacles that may matter to them
  std::uint64_t trianglesOut = 0;  ///< walkable triangles that its filters left
  int thread = 0;                  ///< thread that began it
  double startMs = 0;              ///< since the run began
  double endMs = 0;
  /// The spans in which threads worked on the cell, in order of time. Idle threads may help with a cell, so spans can
  /// be on several threads.
  std::vector<CellSpan> spans;

  /// Time that threads spent on the cell: the sum of its spans.
  [[nodiscard]] double workMs() const;
};

/// A parallel block: from a strategy to Collapse.
struct BlockReport {
  std::size_t firstStep = 0;  ///< the strategy's, among the enabled steps
  std::size_t lastStep = 0;   ///< Collapse's
  std::string strategy;       ///< strategy that made the cells, with its parameters
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

/// The times of the parts of a run (thesis 5.4), in milliseconds. Without a block, all filters are pre-processing.
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
