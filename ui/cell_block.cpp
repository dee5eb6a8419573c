// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cell_block.hpp"

#include <algorithm>

namespace footfall {

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

double CellBlock::shareDone() const {
  double done = 0;
  double all = 0;
  for (std::size_t i = 0; i < report.cells.size(); ++i) {
    const double cost = report.cells[i].cost + 1;  // a cell of no cost is work as well
    all += cost;
    if (finished[i]) done += cost;
  }
  return all > 0 ? done / all : 0;
}

}  // namespace footfall
