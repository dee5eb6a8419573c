// Where a window is at first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMargins>
#include <QRect>
#include <QSize>

class QWidget;

namespace footfall::ui {

/// The area of a window within its frame, so that all of it lies in `available`: of the wanted size where that fits, in
/// the middle.
[[nodiscard]] QRect firstGeometry(const QRect& available, const QMargins& frame, const QSize& wanted);

/// Gives a window that has not been shown yet its first place and size, on the screen that it is to be on.
void placeAtFirst(QWidget& window, const QSize& wanted);

}  // namespace footfall::ui
