// Describes the barrier between two parts of the walkable area, in the user's language and in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "footfall/path.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/overlays/view_overlay.hpp"

namespace footfall::ui {

/// Formats a length or a place that is in the level's units and axes.
struct LevelWriter {
  std::function<QString(double)> length;
  std::function<QString(const Vec3&)> place;
};

/// A sentence such as "The parts are nearest at 4, 1, 0: a step of 0.43 m up."
QString separationText(const Separation& separation, const LevelWriter& write);
/// The obstacle between two borders: "a step of 0.43 m up, 0.03 m too high"; `link` is one of `separation`.
QString lackText(const BorderLink& link, const Separation& separation, const LevelWriter& write);

/// Adds all links, the largest one with its text.
void addSeparation(ViewOverlay& overlay, const Separation& separation, const LevelWriter& write);

/// A box around the largest link for the camera, with `margin` on all sides.
std::array<Vec3, 2> boundsOf(const Separation& separation, double margin);

}  // namespace footfall::ui
