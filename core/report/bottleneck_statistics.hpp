// Bottlenecks in the statistics of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "footfall/corridor_map.hpp"

namespace footfall::detail {

/// Puts `bottlenecks` into statistics as formatStatistics() makes them: `count` (of the map), `slits` and `shallow`
/// (how many are not listed, by usualBottlenecks()), and `listed`, narrowest first, each as in formatCorridorsJson()
/// but with the width of the widest place on either side instead of its number. Places are in the file's frame.
std::string addBottlenecks(const std::string& statistics, const CorridorMap& map);

}  // namespace footfall::detail
