// The areas that AreaFilter compares with on a grid of coordinates (docs/explanation/coordinates.md).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// The minimum area, and what rounding adds at most to a region of that size whose outline is not much longer than a
/// square's: a step along twice the square's sides. So a table of exactly the minimum goes however it stands. 0 stays
/// 0; without a grid the minimum stays as it is.
[[nodiscard]] inline double areaOnGrid(const CoordinateGrid& grid, double minimum) {
  return minimum + 8 * std::sqrt(minimum) * grid.step;
}

}  // namespace footfall::detail
