// Patterns that are drawn over a paint.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace footfall::detail {

/// Drawn over a paint, so that what was removed differs from layers in more than colour. The numbers are those of
/// shaders/surface.frag.
enum class FillPattern : std::uint8_t {
  Plain = 0,
  RisingStripes = 1,
  FallingStripes = 2,
  Dots = 3,
  Grid = 4,
  LevelStripes = 5,
  UprightStripes = 6
};

}  // namespace footfall::detail
