// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/overlays/handle_colours.hpp"

#include <array>
#include <cstddef>

#include "ui/base/look/core_colours.hpp"

namespace footfall::ui {

QColor axisColour(int axis) {
  constexpr std::array<Rgb, 3> kAxes{kVermilion, kBluishGreen, kBlue};
  return toColour(kAxes[static_cast<std::size_t>(axis)]);
}

QColor handleColour() { return {240, 240, 240}; }
QColor highlightColour() { return {255, 196, 0}; }

}  // namespace footfall::ui
