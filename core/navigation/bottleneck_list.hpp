// The bottlenecks of a corridor map that are worth a line in a list, or on a plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "footfall/corridor_map.hpp"

namespace footfall::detail {

/// Metres: narrower slits between modelled things are passages for nobody, and levels have hundreds of them.
inline constexpr double kNarrowestPassage = 0.1;

/// Widths are in the environment's units.
struct BottleneckRule {
  double widerThan = 0;
  double narrowerThan = std::numeric_limits<double>::infinity();
  double leastProminence = kUsualProminence;
};

/// The rule that command, editor, plan and report have unless somebody sets another one.
BottleneckRule usualBottlenecks(double metresPerUnit);

struct BottleneckList {
  std::vector<std::size_t> listed;  ///< numbers of the map's bottlenecks, narrowest first
  std::size_t slits = 0;    ///< how many are left out because they are too narrow; they are the map's first ones
  std::size_t shallow = 0;  ///< how many others are left out because their prominence is too small
};

/// Bottlenecks that are not narrower than `narrowerThan` count nowhere.
BottleneckList listBottlenecks(const CorridorMap& map, const BottleneckRule& rule);

}  // namespace footfall::detail
