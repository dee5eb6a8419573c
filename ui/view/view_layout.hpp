// Where what lies over the view goes: nothing covers anything else, and nothing is cut off.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QSize>
#include <QWidget>
#include <vector>

#include "ui/view/overlay_frame.hpp"
#include "ui/view/view_hint.hpp"

namespace footfall::ui {

/// Children of the view; those that are null or hidden take no place. Legends that somebody has moved stay there.
struct ViewLayout {
  OverlayFrame* legend = nullptr;  ///< lower left
  QWidget* gizmo = nullptr;        ///< upper right
  QWidget* heights = nullptr;      ///< below it, as high as there is room; else beside it
  ViewHint* hint = nullptr;        ///< beside the heights, of which it tells; below them in a narrow view
  OverlayFrame* cells = nullptr;   ///< lower right
  QWidget* cutBar = nullptr;       ///< upper left

  void place(const QSize& view) const;
  /// What of the view they cover.
  [[nodiscard]] std::vector<QRect> covered() const;
};

}  // namespace footfall::ui
