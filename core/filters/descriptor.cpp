// The list of all filters, in the order of their types. Names of filters stand in core/filters/descriptors alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>

#include "core/filters/descriptors/descriptors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall {

namespace {
using namespace detail;

using Description = FilterDescriptor (*)();

// The switch has no default, so that a type without a description does not compile.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"
constexpr Description descriptionOf(FilterType type) {
  switch (type) {
    case FilterType::Duplication:
      return describeDuplication;
    case FilterType::Degeneracy:
      return describeDegeneracy;
    case FilterType::Slope:
      return describeSlope;
    case FilterType::VerticalClearance:
      return describeVerticalClearance;
    case FilterType::Step:
      return describeStep;
    case FilterType::Radius:
      return describeRadius;
    case FilterType::Drop:
      return describeDrop;
    case FilterType::Reachable:
      return describeReachable;
    case FilterType::Area:
      return describeArea;
    case FilterType::Simplification:
      return describeSimplification;
    case FilterType::LayerSubdivision:
      return describeLayerSubdivision;
    case FilterType::Rounding:
      return describeRounding;
    case FilterType::GridStrategy:
      return describeGridStrategy;
    case FilterType::RecursiveStrategy:
      return describeRecursiveStrategy;
    case FilterType::SortedRecursiveStrategy:
      return describeSortedRecursiveStrategy;
    case FilterType::HeightAwareStrategy:
      return describeHeightAwareStrategy;
    case FilterType::AutoStrategy:
      return describeAutoStrategy;
    case FilterType::Collapse:
      return describeCollapse;
  }
  return nullptr;
}
#pragma GCC diagnostic pop

static_assert(descriptionOf(FilterType{kFilterTypes}) == nullptr, "kFilterTypes is the number of all types");

}  // namespace

std::span<const FilterDescriptor> filterDescriptors() {
  static const std::vector<FilterDescriptor> descriptors = [] {
    std::vector<FilterDescriptor> all;
    for (std::uint8_t type = 0; type < kFilterTypes; ++type) all.push_back(descriptionOf(FilterType{type})());
    return all;
  }();
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
