// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/handle_colours.hpp"

#include <array>
#include <cstddef>

namespace footfall::ui {

QColor axisColour(int axis) {
  constexpr std::array<QRgb, 3> kAxes{0xD55E00, 0x009E73, 0x0072B2};
  return QColor::fromRgb(kAxes[static_cast<std::size_t>(axis)]);
}

QColor handleColour() { return {240, 240, 240}; }
QColor highlightColour() { return {255, 196, 0}; }

}  // namespace footfall::ui
