// Colours of handles in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace footfall::ui {

/// The colours of handles that move along X (0), Y (1) and Z (2): vermilion, bluish green and blue of Okabe and Ito.
/// The directions of the arrows distinguish them without colours.
QColor axisColour(int axis);
/// The colour of the other handles.
QColor handleColour();
/// The colour of the selected object, or of the one under the mouse.
QColor highlightColour();

}  // namespace footfall::ui
