// Counts lines of one kind around each line; lines in a crowd are drawn fainter.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// Sets LineSegment::crowd; "around" is about a hundredth of the extent of all lines. It is 0 for few lines, and for
/// lines that are alone.
void setCrowds(std::vector<LineSegment>& lines);

}  // namespace footfall::ui
