// Four floats in one register (an extension of GCC and Clang on all processors).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace footfall::detail {

using Float4 = float __attribute__((vector_size(16)));
/// The result of comparing two Float4: all bits of a lane, or none.
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// A bit mask; bit i is set where lane i of a comparison is true, or negative.
inline unsigned maskOf(Int4 lanes) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(lanes)));
#else
  return (lanes[0] < 0 ? 1U : 0U) | (lanes[1] < 0 ? 2U : 0U) | (lanes[2] < 0 ? 4U : 0U) | (lanes[3] < 0 ? 8U : 0U);
#endif
}

}  // namespace footfall::detail
