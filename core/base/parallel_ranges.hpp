// Loops over ranges of numbers on all threads of the run, for headers that cannot include the thread library's.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace footfall::detail {

/// Calls body(first, last) for ranges that together are 0 to count, on any thread and in any order. Ranges are longer
/// than half of `size`, and at most `size` long; up to so many numbers are one call on this thread.
void forRanges(std::size_t count, std::size_t size, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace footfall::detail
