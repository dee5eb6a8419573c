// A run's blocks as lanes of bars, for the timeline: plain data, no widget.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "ui/base/processor_use.hpp"
#include "ui/view/cell_block.hpp"

namespace footfall::ui {

struct Timeline {
  struct Segment {
    std::size_t filter = 0;  ///< index into filters
    double start = 0, end = 0;
  };
  /// One cell (or what the whole block shares) on one thread, from its first filter to its last without another cell
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
  /// Everything that is not done cell by cell: the run beside its blocks, and partitioning and merging.
  struct Serial {
    enum class Kind { Start, Step, Between, Partitioning, Merging, Finish };
    Kind kind = Kind::Step;
    std::string filter;  ///< of a step
    double start = 0, end = 0;
    double threads = 1;  ///< that it kept busy, on average
  };

  int lanes = 0;
  std::vector<Bar> bars;  ///< by lane, then by time
  std::vector<Band> bands;
  std::vector<Serial> serial;        ///< in order of time
  ProcessorUse processors;           ///< of the run
  std::vector<std::string> filters;  ///< that segments name, in the order in which they were met
  double start = 0, end = 0;         ///< milliseconds since the run began; units of work of a plan
  bool planned = false;              ///< nothing of it has run

  /// The bar at a time on a lane; null when the thread was idle.
  [[nodiscard]] const Bar* at(int lane, double time) const;
};

/// Where the time of all threads of a run went, in milliseconds of thread time.
struct TimeUse {
  double cells = 0;           ///< at work on cells
  double steps = 0;           ///< at work on everything else
  double waitingForWork = 0;  ///< while other threads had the last cells
  double waitingForStep = 0;  ///< while something ran that keeps fewer threads busy
  double otherPrograms = 0;   ///< ready to work, but no processor was free
  [[nodiscard]] double total() const { return cells + steps + waitingForWork + waitingForStep + otherPrograms; }
};
TimeUse timeUse(const Timeline& timeline);

/// What can be expected of a block that has not begun: its cells by estimated cost, longest first, over the threads.
Timeline planTimeline(const CellBlock& block, std::size_t number, int threads);

/// The blocks that ran in the same run as `shown`, on one axis of time.
Timeline makeTimeline(const CellBlocks& blocks, std::size_t shown);

}  // namespace footfall::ui
