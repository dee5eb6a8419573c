// A parallel block as the window knows it, before, during and after its run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "footfall/statistics.hpp"
#include "ui/base/processor_use.hpp"

namespace footfall::ui {

/// A part of a run beside its parallel blocks. Steps that came from the cache are none.
struct RunPart {
  enum class Kind { Start, Step, Finish };  ///< the first state, a filter, the navigation mesh
  Kind kind = Kind::Step;
  std::string filter;  ///< its name; empty for the other kinds
  double startMs = 0, endMs = 0;
  double cpuMs = -1;  ///< of the whole process; negative: not known
};

/// What a finished run took.
struct RunFigures {
  RunTimes times;
  int threads = 1;
  std::vector<RunPart> parts = {};  ///< in order of time
  ProcessorUse processors = {};
};

/// The processes that ran a block's cells, where these are others than the editor.
struct CellRanks {
  int own = 0;               ///< threads of the editor, which have the first numbers
  std::vector<int> threads;  ///< of each rank; empty: the editor ran the cells

  [[nodiscard]] bool empty() const { return threads.empty(); }
  /// Whose a thread is, and which of its own; rank -1: the editor.
  struct Place {
    int rank = -1, thread = 0;
  };
  [[nodiscard]] Place placeOf(int thread) const;
};

struct CellBlock {
  /// Where the figures come from: the last run, an earlier one whose result the last run took from the cache, or runs
  /// that were made to measure.
  enum class Origin { Run, Cache, Measured };

  BlockReport report;          ///< cells that have not finished have bounds and costs only
  std::vector<char> finished;  ///< for each cell
  /// Null while the block runs, and before. Blocks of one run share it.
  std::shared_ptr<const RunFigures> run;
  CellRanks ranks = {};
  Origin origin = Origin::Run;

  [[nodiscard]] bool complete() const { return run != nullptr; }
  /// A cell has finished.
  [[nodiscard]] bool begun() const;
  /// One more than the largest thread that has worked on it, at least that of its run.
  [[nodiscard]] int threads() const;
  /// How long each rank was busy with cells, its threads together; empty where there are no ranks.
  [[nodiscard]] std::vector<double> busyMsOfRanks() const;
};

using CellBlocks = std::vector<CellBlock>;

/// A cell among the blocks that are shown.
struct CellId {
  std::size_t block = 0, cell = 0;
  auto operator<=>(const CellId&) const = default;
};

}  // namespace footfall::ui
