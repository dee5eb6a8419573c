// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/cell_block.hpp"

#include <algorithm>

namespace footfall::ui {

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

}  // namespace footfall::ui
