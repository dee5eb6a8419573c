// The colours of widths in the corridor map.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>
#include <cstddef>

namespace footfall::ui {

/// Widths are shown as multiples of an agent's width: too narrow, up to 1.5 times, twice, four times it, and wider.
constexpr std::array<double, 4> kWidthLimits = {1, 1.5, 2, 4};
constexpr std::size_t kWidthColours = kWidthLimits.size() + 1;

/// The number of a width's colour, from 0 for a width below the agent's.
std::size_t colourNumberOf(double width, double agentWidth);

/// The colour with a number: from warm to cold, and distinguishable in every kind of colour blindness.
QColor widthColour(std::size_t number);

inline QColor colourOfWidth(double width, double agentWidth) { return widthColour(colourNumberOf(width, agentWidth)); }

}  // namespace footfall::ui
