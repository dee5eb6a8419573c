// Colours of handles in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace footfall::ui {

/// The colours of handles that move along X (0), Y (1) and Z (2): vermilion, bluish green and blue of Okabe and Ito.
/// Who cannot tell them apart sees where the arrows point.
QColor axisColour(int axis);
/// The colour of the other handles.
QColor handleColour();
/// The colour of what is selected, or what the mouse is on.
QColor highlightColour();

}  // namespace footfall::ui
