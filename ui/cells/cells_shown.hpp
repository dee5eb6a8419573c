// Where the cells of parallel blocks are shown.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {

struct CellsShown {
  bool inView = false;
  bool load = false;  ///< in the dock with the timeline
  CellColouring colouring = CellColouring::Thread;
};

}  // namespace footfall::ui
