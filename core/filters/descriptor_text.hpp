// The descriptors in words: for messages, `footfall filters` and docs/reference/filters.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "footfall/text.hpp"

namespace footfall {
struct FilterDescriptor;
struct ParameterDescriptor;
}  // namespace footfall

namespace footfall::detail {

/// A value as it stands in a pipeline file: true or false, or the shortest digits that read back to the same double.
std::string formatValue(const ParameterDescriptor& parameter, double value);

/// The range of a value, e.g. "a number above 0 and below 90 (degrees)".
Text describeRange(const ParameterDescriptor& parameter);

/// The form of the filter in a pipeline file, e.g. "SimplificationFilter [approximate [tolerance]]".
std::string describeUsage(const FilterDescriptor& filter);

/// Everything about one filter as plain text of at most 100 columns, ending in a line break.
std::string describeFilter(const FilterDescriptor& filter);

/// All filters in one line each, ending in a line break.
std::string listFilters();

/// All filters as a Markdown document: docs/reference/filters.md.
std::string filtersMarkdown();

/// The known filter name or alias that `name` most likely stands for (fewest edits, letter case ignored).
std::string_view nearestFilterName(std::string_view name);

}  // namespace footfall::detail
