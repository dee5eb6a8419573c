// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/bottleneck_list.hpp"

namespace footfall::detail {

BottleneckRule usualBottlenecks(double metresPerUnit) {
  BottleneckRule rule;
  rule.widerThan = kNarrowestPassage / metresPerUnit;
  return rule;
}

BottleneckList listBottlenecks(const CorridorMap& map, const BottleneckRule& rule) {
  BottleneckList list;
  for (std::size_t i = 0; i < map.bottlenecks.size(); ++i) {
    const Bottleneck& bottleneck = map.bottlenecks[i];
    if (bottleneck.width >= rule.narrowerThan) break;  // the narrowest come first
    if (bottleneck.width <= rule.widerThan)
      ++list.slits;
    else if (prominence(map, bottleneck) < rule.leastProminence)
      ++list.shallow;
    else
      list.listed.push_back(i);
  }
  return list;
}

}  // namespace footfall::detail
