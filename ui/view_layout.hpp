// Where what lies over the view goes: nothing covers anything else, and nothing is cut off.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QWidget>

namespace footfall {

/// Children of the view; those that are null or hidden take no place.
struct ViewLayout {
  QWidget* legend = nullptr;   ///< lower left
  QWidget* gizmo = nullptr;    ///< upper right
  QWidget* heights = nullptr;  ///< below it, as high as there is room; else beside it
  QWidget* cells = nullptr;    ///< lower right
  QWidget* cutBar = nullptr;   ///< upper left

  void place(const QSize& view) const;
};

}  // namespace footfall
