// What keeps two parts of the walkable area apart, in the user's language and in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "footfall/path.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/view_overlay.hpp"

namespace footfall::ui {

/// Writes a length, or a place, that is given in the level's units and axes.
struct LevelWriter {
  std::function<QString(double)> length;
  std::function<QString(const Vec3&)> place;
};

/// "The parts are nearest at 4, 1, 0: a step of 0.43 m up."
QString separationText(const Separation& separation, const LevelWriter& write);
/// What is missing between two borders: "a step of 0.43 m up, 0.03 m too high"; `link` is one of `separation`.
QString lackText(const BorderLink& link, const Separation& separation, const LevelWriter& write);

/// All links, the largest with its text.
void addSeparation(ViewOverlay& overlay, const Separation& separation, const LevelWriter& write);

/// A box around the largest link, for the camera; `margin` on all sides.
std::array<Vec3, 2> boundsOf(const Separation& separation, double margin);

}  // namespace footfall::ui
