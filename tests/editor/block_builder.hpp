// Reports of parallel blocks made by hand, for suites about what the editor shows of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ui/view/cells/cell_block.hpp"

namespace footfall::test {
using namespace ui;

/// A block of cells side by side along x, each one unit wide; the outer sides are open.
class BlockBuilder {
 public:
  explicit BlockBuilder(std::size_t cells, const std::string& strategy = "GridStrategy 4 1") {
    block_.report.strategy = strategy;
    block_.report.firstStep = 0;
    block_.report.lastStep = 2;
    block_.report.cells.resize(cells);
    block_.finished.assign(cells, 0);
    for (std::size_t i = 0; i < cells; ++i) {
      CellReport& cell = block_.report.cells[i];
      cell.cost = 10.0 * static_cast<double>(i + 1);
      cell.trianglesIn = 100 * (i + 1);
      if (i > 0) cell.bounds.lower[0] = static_cast<double>(i);
      if (i + 1 < cells) cell.bounds.upper[0] = static_cast<double>(i + 1);
    }
  }

  BlockBuilder& phases(double start, double partitioning, double parallel, double merging) {
    block_.report.startMs = start;
    block_.report.partitioningMs = partitioning;
    block_.report.parallelMs = parallel;
    block_.report.mergingMs = merging;
    return *this;
  }
  /// A filter on a cell; the first one of a cell begins it, and the cell counts as finished.
  BlockBuilder& work(std::size_t cell, const std::string& filter, int thread, double start, double end) {
    CellReport& report = block_.report.cells[cell];
    if (report.spans.empty()) {
      report.thread = thread;
      report.startMs = start;
      report.trianglesOut = 7;
    }
    report.endMs = end;
    report.spans.push_back({filter, thread, start, end});
    block_.finished[cell] = 1;
    return *this;
  }
  BlockBuilder& shared(const std::string& filter, int thread, double start, double end) {
    block_.report.shared.push_back({filter, thread, start, end});
    return *this;
  }
  BlockBuilder& reason(const std::string& text) {
    block_.report.reason = text;
    return *this;
  }
  BlockBuilder& ran(const RunTimes& times, int threads) {
    block_.run = std::make_shared<const RunFigures>(RunFigures{times, threads});
    return *this;
  }
  /// Puts the block into the same run as another block.
  BlockBuilder& ranWith(const CellBlock& other) {
    block_.run = other.run;
    return *this;
  }
  [[nodiscard]] CellBlock block() const { return block_; }

 private:
  CellBlock block_;
};

/// Four cells on two threads: thread 0 does the cells 0 and 1, thread 1 the cells 2 and 3 and waits from 50 to 60 ms;
/// thread 0 helps with cell 3.
inline CellBlock fourCells() {
  return BlockBuilder(4)
      .phases(10, 10, 40, 5)
      .work(0, "DegeneracyFilter", 0, 20, 22)
      .work(0, "VerticalClearanceFilter", 0, 22, 40)
      .work(1, "VerticalClearanceFilter", 0, 40, 48)
      .work(2, "VerticalClearanceFilter", 1, 20, 30)
      .work(3, "VerticalClearanceFilter", 1, 30, 50)
      .work(3, "VerticalClearanceFilter", 0, 52, 60)
      .ran({.preprocessing = 10,
            .partitioning = 10,
            .parallel = 40,
            .merging = 5,
            .postprocessing = 20,
            .overhead = 3,
            .total = 88},
           2)
      .block();
}

}  // namespace footfall::test
