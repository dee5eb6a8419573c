// Where lines of one kind are many, each is drawn the fainter; here they are counted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// Sets LineSegment::crowd; "around" is about a hundredth of the extent of all lines. 0 for lines that are few, or
/// alone.
void setCrowds(std::vector<LineSegment>& lines);

}  // namespace footfall::ui
