// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/load_balancing.hpp"

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

namespace footfall::detail {

std::vector<std::size_t> longestFirst(std::span<const double> costs) {
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  return order;
}

double LoadBalance::imbalance() const {
  if (loads.empty()) return 1;
  const double largest = *std::max_element(loads.begin(), loads.end());
  if (!(largest > 0)) return 1;
  // Sums in units of the largest, so that none overflows.
  double sum = 0;
  for (const double load : loads) sum += load / largest;
  return static_cast<double>(loads.size()) / sum;
}

LoadBalance assignLongestFirst(std::span<const double> costs, std::size_t bins) {
  LoadBalance balance;
  balance.bins.resize(bins);
  balance.loads.assign(bins, 0);
  using Bin = std::pair<double, std::size_t>;  // smallest load first, then smallest number
  std::priority_queue<Bin, std::vector<Bin>, std::greater<>> queue;
  for (std::size_t bin = 0; bin < bins; ++bin) queue.push({0, bin});
  for (const std::size_t task : longestFirst(costs)) {
    const std::size_t bin = queue.top().second;
    queue.pop();
    balance.bins[bin].push_back(task);
    balance.loads[bin] += costs[task];
    queue.push({balance.loads[bin], bin});
  }
  return balance;
}

}  // namespace footfall::detail
