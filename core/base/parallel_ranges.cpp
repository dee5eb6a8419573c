// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_ranges.hpp"

#include <oneapi/tbb/parallel_for.h>

namespace footfall::detail {

void forRanges(std::size_t count, std::size_t size, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  if (count <= size) return body(0, count);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, size), [&body](const auto& range) { body(range.begin(), range.end()); },
      tbb::simple_partitioner());
}

}  // namespace footfall::detail
