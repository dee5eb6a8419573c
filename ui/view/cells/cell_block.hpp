// A parallel block before, during and after its run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "footfall/statistics.hpp"
#include "ui/base/work/processor_use.hpp"

namespace footfall::ui {

/// A part of a run outside of its parallel blocks. Cached steps are not included.
struct RunPart {
  enum class Kind { Start, Step, Finish };  ///< Start: the first state; Step: a filter; Finish: the navigation mesh
  Kind kind = Kind::Step;
  std::string filter;  ///< name of the filter; empty for the other kinds
  double startMs = 0, endMs = 0;
  double cpuMs = -1;  ///< processor time of the whole process; negative: not known
};

/// The times of a finished run.
struct RunFigures {
  RunTimes times;
  int threads = 1;
  std::vector<RunPart> parts = {};  ///< in order of time
  ProcessorUse processors = {};
};

/// The processes that ran a block's cells, where these are not the editor.
struct CellRanks {
  int own = 0;               ///< threads of the editor, which have the first numbers
  std::vector<int> threads;  ///< threads of each rank; empty: the editor ran the cells

  [[nodiscard]] bool empty() const { return threads.empty(); }
  /// The rank of a thread and its number there; rank -1: the editor.
  struct Place {
    int rank = -1, thread = 0;
  };
  [[nodiscard]] Place placeOf(int thread) const;
};

struct CellBlock {
  /// The origin of the figures: the last run, an earlier run whose result the last one took from the cache, or measured
  /// runs.
  enum class Origin { Run, Cache, Measured };

  BlockReport report;          ///< unfinished cells have bounds and costs only
  std::vector<char> finished;  ///< for each cell
  /// Null before and during the run. Blocks of one run share it.
  std::shared_ptr<const RunFigures> run;
  CellRanks ranks = {};
  Origin origin = Origin::Run;

  [[nodiscard]] bool complete() const { return run != nullptr; }
  /// Returns whether a cell has finished.
  [[nodiscard]] bool begun() const;
  /// The largest number of a thread that worked on the block, plus one; at least the threads of its run.
  [[nodiscard]] int threads() const;
  /// The time that each rank spent on cells, its threads together; empty where there are no ranks.
  [[nodiscard]] std::vector<double> busyMsOfRanks() const;
};

using CellBlocks = std::vector<CellBlock>;

/// A cell of the shown blocks.
struct CellId {
  std::size_t block = 0, cell = 0;
  auto operator<=>(const CellId&) const = default;
};

}  // namespace footfall::ui
