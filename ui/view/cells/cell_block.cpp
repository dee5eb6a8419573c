// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/cells/cell_block.hpp"

#include <algorithm>

namespace footfall::ui {

CellRanks::Place CellRanks::placeOf(int thread) const {
  if (thread < own) return {-1, thread};
  thread -= own;
  std::size_t rank = 0;
  for (; rank + 1 < threads.size() && thread >= threads[rank]; ++rank) thread -= threads[rank];
  return {static_cast<int>(rank), thread};
}

bool CellBlock::begun() const {
  return complete() || std::ranges::any_of(finished, [](char done) { return done != 0; });
}

int CellBlock::threads() const {
  int threads = run ? run->threads : 1;
  for (const CellReport& cell : report.cells) {
    threads = std::max(threads, cell.thread + 1);
    for (const CellSpan& span : cell.spans) threads = std::max(threads, span.thread + 1);
  }
  for (const CellSpan& span : report.shared) threads = std::max(threads, span.thread + 1);
  return threads;
}

std::vector<double> CellBlock::busyMsOfRanks() const {
  std::vector<double> busy(ranks.threads.size(), 0);
  const std::vector<double> ofThreads = report.busyMs(threads());
  for (std::size_t thread = 0; thread < ofThreads.size() && !ranks.empty(); ++thread)
    if (const int rank = ranks.placeOf(static_cast<int>(thread)).rank; rank >= 0)
      busy[static_cast<std::size_t>(rank)] += ofThreads[thread];
  return busy;
}

}  // namespace footfall::ui
