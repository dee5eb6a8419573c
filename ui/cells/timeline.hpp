// The data of the timeline: a run's blocks as lanes of bars, without widgets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "ui/base/work/processor_use.hpp"
#include "ui/view/cells/cell_block.hpp"

namespace footfall::ui {

struct Timeline {
  struct Segment {
    std::size_t filter = 0;  ///< index into filters
    double start = 0, end = 0;
  };
  /// A cell (or the shared part of a block) on one thread, from its first filter to its last without another cell
  /// between.
  struct Bar {
    std::optional<CellId> cell;
    int lane = 0;
    double start = 0, end = 0;
    std::vector<Segment> segments;
  };
  enum class Phase { Partitioning, Parallel, Merging };
  struct Band {
    Phase phase = Phase::Parallel;
    double start = 0, end = 0;
  };
  /// A part of the run that is not done cell by cell: steps outside of blocks, partitioning and merging.
  struct Serial {
    enum class Kind { Start, Step, Between, Partitioning, Merging, Finish };
    Kind kind = Kind::Step;
    std::string filter;  ///< name of the step's filter
    double start = 0, end = 0;
    double threads = 1;  ///< number of threads that it kept busy, on average
  };

  int lanes = 0;
  std::vector<Bar> bars;  ///< ordered by lane, then by time
  std::vector<Band> bands;
  std::vector<Serial> serial;        ///< in order of time
  ProcessorUse processors;           ///< processors of the run
  std::vector<std::string> filters;  ///< filters of the segments, in the order of their first use
  double start = 0, end = 0;         ///< milliseconds since the run began; units of work in a plan
  bool planned = false;              ///< nothing of it has run

  /// The bar at a time on a lane; null when the thread was idle.
  [[nodiscard]] const Bar* at(int lane, double time) const;
};

/// The uses of all threads' time in a run, in milliseconds of thread time.
struct TimeUse {
  double cells = 0;           ///< work on cells
  double steps = 0;           ///< all other work
  double waitingForWork = 0;  ///< idle while other threads had the last cells
  double waitingForStep = 0;  ///< idle during steps that keep fewer threads busy
  double otherPrograms = 0;   ///< ready to work while no processor was free
  [[nodiscard]] double total() const { return cells + steps + waitingForWork + waitingForStep + otherPrograms; }
};
TimeUse timeUse(const Timeline& timeline);

/// The expected timeline of a block that has not begun: its cells by estimated cost, longest first, over the threads.
Timeline planTimeline(const CellBlock& block, std::size_t number, int threads);

/// The blocks of the same run as `shown`, on one axis of time.
Timeline makeTimeline(const CellBlocks& blocks, std::size_t shown);

}  // namespace footfall::ui
