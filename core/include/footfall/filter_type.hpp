// The numbers of the filters. Only code that names a filter includes this: a new filter changes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace footfall {

/// The types by which code decides; files and people use the names of filters. The order is the one in which users see
/// the filters.
enum class FilterType : std::uint8_t {
  Duplication,
  Degeneracy,
  Slope,
  VerticalClearance,
  Step,
  Radius,
  Drop,
  Reachable,
  Area,
  Simplification,
  LayerSubdivision,
  Rounding,
  GridStrategy,
  RecursiveStrategy,
  SortedRecursiveStrategy,
  HeightAwareStrategy,
  AutoStrategy,
  Collapse
};

/// The number of types: that of the last one, and one more.
inline constexpr std::uint8_t kFilterTypes = static_cast<std::uint8_t>(FilterType::Collapse) + 1;

}  // namespace footfall
