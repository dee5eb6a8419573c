// Longest processing time first: tasks of known cost over equal workers (thesis 4.3.4; Graham 1969).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace footfall::detail {

/// The tasks by falling cost; equal ones in their given order.
std::vector<std::size_t> longestFirst(std::span<const double> costs);

struct LoadBalance {
  std::vector<std::vector<std::size_t>> bins;  ///< the tasks of each bin, in the order in which they were assigned
  std::vector<double> loads;                   ///< the cost of each bin

  /// Largest load over the mean; 1 when there is no load.
  [[nodiscard]] double imbalance() const;
};

/// Gives each task, longest first, to the bin with the smallest load so far (the first of equal ones). Deterministic.
/// `bins` is at least 1; costs are finite and not negative.
LoadBalance assignLongestFirst(std::span<const double> costs, std::size_t bins);

}  // namespace footfall::detail
