// The initial place of a window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMargins>
#include <QRect>
#include <QSize>

class QWidget;

namespace footfall::ui {

/// The area of a window within its frame, so that all of it lies in `available`: centred, with the wanted size where it
/// fits.
[[nodiscard]] QRect firstGeometry(const QRect& available, const QMargins& frame, const QSize& wanted);

/// Sets the initial place and size of a window that has not been shown yet, on its screen.
void placeAtFirst(QWidget& window, const QSize& wanted);

}  // namespace footfall::ui
