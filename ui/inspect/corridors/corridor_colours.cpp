// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/corridors/corridor_colours.hpp"

#include <algorithm>

#include "ui/base/look/core_colours.hpp"

namespace footfall::ui {

std::size_t colourNumberOf(double width, double agentWidth) {
  const auto* const limit =
      std::ranges::find_if(kWidthLimits, [&](double times) { return width < times * agentWidth; });
  return static_cast<std::size_t>(limit - kWidthLimits.begin());
}

// The map lies on floors in the colours of layers; a dark rim keeps its lines apart from them.
QColor widthColour(std::size_t number) {
  static const std::array<QColor, kWidthColours> kColours = {
      toColour(kVermilion), QColor(253, 174, 97), QColor(255, 255, 191), QColor(171, 217, 233), QColor(69, 117, 180)};
  return kColours.at(std::min(number, kWidthColours - 1));
}

}  // namespace footfall::ui
