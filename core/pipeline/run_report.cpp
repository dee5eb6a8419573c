// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "footfall/statistics.hpp"

namespace footfall {

double CellReport::workMs() const {
  double sum = 0;
  for (const CellSpan& span : spans) sum += span.endMs - span.startMs;
  return sum;
}

std::vector<double> BlockReport::busyMs(int threads) const {
  std::vector<double> busy(static_cast<std::size_t>(threads), 0);
  for (const CellReport& cell : cells)
    for (const CellSpan& span : cell.spans) busy.at(static_cast<std::size_t>(span.thread)) += span.endMs - span.startMs;
  return busy;
}

double BlockReport::imbalance(int threads) const {
  const std::vector<double> busy = busyMs(threads);
  const double sum = std::accumulate(busy.begin(), busy.end(), 0.0);
  return sum > 0 ? *std::max_element(busy.begin(), busy.end()) * threads / sum : 1;
}

}  // namespace footfall
