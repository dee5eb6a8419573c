// The list of all filters. Names of filters stand in core/filters/descriptors alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/filters/descriptors/descriptors.hpp"
#include "footfall/filter.hpp"

namespace footfall {

std::span<const FilterDescriptor> filterDescriptors() {
  static const std::vector<FilterDescriptor> descriptors = {
      detail::describeDuplication(),
      detail::describeDegeneracy(),
      detail::describeSlope(),
      detail::describeVerticalClearance(),
      detail::describeStep(),
      detail::describeRadius(),
      detail::describeDrop(),
      detail::describeReachable(),
      detail::describeArea(),
      detail::describeSimplification(),
      detail::describeLayerSubdivision(),
      detail::describeRounding(),
      detail::describeGridStrategy(),
      detail::describeRecursiveStrategy(),
      detail::describeSortedRecursiveStrategy(),
      detail::describeHeightAwareStrategy(),
      detail::describeAutoStrategy(),
      detail::describeCollapse(),
  };
  return descriptors;
}

const FilterDescriptor& filterDescriptor(FilterType type) {
  return filterDescriptors()[static_cast<std::size_t>(type)];
}

const FilterDescriptor* findFilter(std::string_view nameOrAlias) {
  for (const FilterDescriptor& filter : filterDescriptors()) {
    if (filter.name == nameOrAlias || std::ranges::count(filter.aliases, nameOrAlias) > 0) return &filter;
  }
  return nullptr;
}

}  // namespace footfall
