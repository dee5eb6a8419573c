// Sorting on all threads of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cstddef>
#include <functional>

#include "core/base/parallel.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

/// Sorts like std::sort(), on any threads. Several threads may call `less` at a time, and it may throw. Throws
/// Cancelled when the sorting ended early, as the functions of parallel.hpp do.
template <class Iterator, class Less = std::less<>>
void parallelSort(Iterator first, Iterator last, const Less& less = {}) {
  constexpr std::size_t kCheckedPerTask = 1 << 14;
  if (last - first < 2) return;
  tbb::parallel_sort(first, last, less);
  // The library's sort has no task group whose state could be read afterwards, so the order itself shows whether it
  // ended early.
  using Distance = decltype(last - first);
  forRanges(static_cast<std::size_t>(last - first) - 1, kCheckedPerTask, [&](std::size_t from, std::size_t to) {
    if (!std::is_sorted(first + static_cast<Distance>(from), first + static_cast<Distance>(to) + 1, less))
      throw Cancelled();
  });
}

}  // namespace footfall::detail
