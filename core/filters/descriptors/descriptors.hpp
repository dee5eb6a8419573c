// The description of each filter, by what filters are for; filterDescriptors() puts them in their order.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

#include "footfall/filter.hpp"

namespace footfall::detail {

/// Limits of parameters that have none of their own.
inline constexpr double kNoLimit = std::numeric_limits<double>::max();
inline constexpr double kLargestInteger = std::numeric_limits<std::int32_t>::max();

// core/filters/descriptors/mesh_filters.cpp
FilterDescriptor describeDuplication();
FilterDescriptor describeDegeneracy();
FilterDescriptor describeSimplification();
FilterDescriptor describeLayerSubdivision();
FilterDescriptor describeRounding();

// core/filters/descriptors/agent_filters.cpp
FilterDescriptor describeSlope();
FilterDescriptor describeVerticalClearance();
FilterDescriptor describeRadius();
FilterDescriptor describeArea();

// core/filters/descriptors/way_filters.cpp
FilterDescriptor describeStep();
FilterDescriptor describeDrop();
FilterDescriptor describeReachable();

// core/filters/descriptors/parallel_blocks.cpp
FilterDescriptor describeGridStrategy();
FilterDescriptor describeRecursiveStrategy();
FilterDescriptor describeSortedRecursiveStrategy();
FilterDescriptor describeHeightAwareStrategy();
FilterDescriptor describeAutoStrategy();
FilterDescriptor describeCollapse();

}  // namespace footfall::detail
