// How often doubles could not decide.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace footfall {

/// Where doubles could not decide and exact arithmetic had to, by kind of decision.
struct ExactFallbacks {
  std::uint64_t slope = 0, height = 0, orientation = 0, side = 0, order = 0, area = 0;
  [[nodiscard]] std::uint64_t total() const { return slope + height + orientation + side + order + area; }
  ExactFallbacks& operator+=(const ExactFallbacks& o) {
    slope += o.slope;
    height += o.height;
    orientation += o.orientation;
    side += o.side;
    order += o.order;
    area += o.area;
    return *this;
  }
};

}  // namespace footfall
