// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/filter_traits.hpp"

#include <algorithm>
#include <stdexcept>

#include "footfall/filter.hpp"

namespace footfall::detail {

const Removal* findRemoval(const FilterTraits& traits, PlaceVerdict verdict) {
  const auto found = std::ranges::find(traits.removals, verdict, &Removal::verdict);
  return found == traits.removals.end() ? nullptr : &*found;
}

ParameterUse parameterUse(const FilterDescriptor& filter, std::size_t parameter) {
  const std::vector<ParameterUse>& uses = filter.traits->parameters;
  return parameter < uses.size() ? uses[parameter] : kPlainParameter;
}

DrivenParameter drivenBy(AgentSize size) {
  for (const FilterDescriptor& filter : filterDescriptors())
    for (std::size_t i = 0; i < filter.parameters.size(); ++i)
      if (parameterUse(filter, i).agentSize == size) return {&filter, i};
  throw std::logic_error("a size of agents drives no filter");
}

}  // namespace footfall::detail
