// Colours of handles in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace footfall::ui {

/// Of handles that move along X (0), Y (1) and Z (2): vermilion, bluish green and blue of Okabe and Ito. Where an arrow
/// points tells the same.
QColor axisColour(int axis);
/// Of the other handles.
QColor handleColour();
/// Of what is selected, or what the mouse is on.
QColor highlightColour();

}  // namespace footfall::ui
