// The corridor map as short lines with a width each, ready for drawing in any scale of colours.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "footfall/corridor_map.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// A piece of an edge of the map.
struct CorridorLine {
  std::array<Vec3, 2> ends{};
  double width = 0;  ///< at its narrower end
};

struct CorridorLines {
  std::vector<CorridorLine> lines;  ///< narrowest first
  std::size_t leftOut = 0;          ///< edges that are not drawn, the widest ones
};

/// Edges whose widest place is at most `least` wide are slits, and have no lines. Edges are cut into pieces, so that
/// parabolas look round and colours follow the width; there are `most` lines at most.
CorridorLines makeCorridorLines(const CorridorMap& map, double least, std::size_t most);

}  // namespace footfall::ui
