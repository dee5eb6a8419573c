// Two doubles in one register (an extension of GCC and Clang on all processors).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace footfall::detail {

using Double2 = double __attribute__((vector_size(16)));
/// The result of comparing two Double2: all bits of a lane, or none.
using Long2 = decltype(Double2{} < Double2{});

/// A bit mask; bit i is set where lane i of a comparison is true.
inline unsigned maskOf(Long2 lanes) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<__m128d>(lanes)));
#else
  return static_cast<unsigned>((lanes[0] & 1) | (lanes[1] & 2));
#endif
}

}  // namespace footfall::detail
