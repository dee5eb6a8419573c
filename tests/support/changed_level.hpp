// A level as somebody turned, scaled or moved it: what a modeller does with a node, and what import does after that.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "footfall/environment.hpp"
#include "footfall/io.hpp"

namespace footfall::test {

struct LevelChange {
  double degrees = 0;  ///< about the vertical
  double scale = 1;    ///< of the coordinates; metresPerUnit changes the other way, so that the level keeps its size
  double offset = 0;   ///< in units, to x and y
};

/// The level with other coordinates, computed in doubles. With GridChoice::On they are put on the usual grid, as import
/// does it with coordinates that matrices placed; with GridChoice::Off they stay as they are.
std::shared_ptr<const Environment> changedLevel(const Environment& level, const LevelChange& change,
                                                GridChoice grid = GridChoice::On);

}  // namespace footfall::test
