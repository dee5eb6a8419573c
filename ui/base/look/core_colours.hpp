// Converts the core's colours to Qt's.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <cstddef>
#include <span>

#include "core/base/palette.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

inline QColor toColour(const Rgb& rgb) { return {rgb[0], rgb[1], rgb[2]}; }

/// The colour with a number. After all colours have been used, they repeat darker, then lighter.
inline QColor numberedColour(std::span<const Rgb> colours, std::size_t number) {
  const QColor colour = toColour(colours[number % colours.size()]);
  const std::size_t round = number / colours.size() % 3;
  return round == 0 ? colour : round == 1 ? colour.darker(150) : colour.lighter(140);
}

}  // namespace footfall::ui
