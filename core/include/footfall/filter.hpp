// Each filter is described once; parser, command line, editor, session file and docs follow from it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "footfall/parameter.hpp"

namespace footfall {

namespace detail {
struct FilterTraits;  // core/filters/filter_traits.hpp
}

enum class FilterType : std::uint8_t;  // footfall/filter_type.hpp names them

/// A strategy begins a parallel block, and Collapse ends it.
enum class FilterKind { Filter, Strategy, Collapse };

/// Local filters may run inside a parallel block; global ones see across cells and may not.
enum class Scope { Local, Global };

/// A filter. Texts live as long as the program.
struct FilterDescriptor {
  FilterType type{};
  std::string_view name;                  ///< name in pipeline files, e.g. "LayerSubdivisionFilter"
  std::vector<std::string_view> aliases;  ///< the thesis's names, e.g. "PEELFilter"
  std::string_view label;                 ///< shown to people, e.g. "Layer subdivision"
  std::string_view help;
  std::string_view precondition;  ///< empty when there is none
  std::string_view effect;
  std::string_view source;  ///< thesis section or paper
  std::vector<ParameterDescriptor> parameters;
  FilterKind kind = FilterKind::Filter;
  Scope scope = Scope::Local;
  /// The number of last parameters that form a group which a step has any number of times, also not at all
  /// (ReachableFilter's x y z); 0: each parameter occurs once.
  std::size_t repeats = 0;
  std::string_view groups{};           ///< name of the groups in JSON, e.g. "seeds"; empty when nothing repeats
  const detail::FilterTraits* traits;  ///< what the library itself decides by

  /// The descriptor of value `index` of a step.
  [[nodiscard]] const ParameterDescriptor& parameterOf(std::size_t index) const {
    const std::size_t once = parameters.size() - repeats;
    return parameters[index < once ? index : once + (index - once) % repeats];
  }
  /// True when a step may have this many values.
  [[nodiscard]] bool takes(std::size_t values) const {
    const std::size_t once = parameters.size() - repeats;
    return repeats == 0 ? values == once : values >= once && (values - once) % repeats == 0;
  }
};

/// All filters, in the order in which users should see them.
std::span<const FilterDescriptor> filterDescriptors();

const FilterDescriptor& filterDescriptor(FilterType type);

/// Finds a filter by name or alias, exact case; nullptr when unknown.
const FilterDescriptor* findFilter(std::string_view nameOrAlias);

}  // namespace footfall
