// A parameter of a filter: its name, unit, default and range. Fields of the editor show numbers by the same
// description.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace footfall {

enum class ParameterType { Real, Integer, Boolean };

/// The measure of a value; lengths and areas are in the environment's units.
enum class Unit { None, Degrees, Length, Area, Count };

/// A parameter of a filter.
struct ParameterDescriptor {
  std::string_view name;   ///< identifier, e.g. "max_slope"
  std::string_view label;  ///< shown to people, e.g. "Maximum slope"
  std::string_view help;   ///< one or two sentences
  ParameterType type = ParameterType::Real;
  Unit unit = Unit::None;
  double defaultValue = 0;  ///< lengths and areas: in metres; the default pipeline converts them. Booleans: 0 or 1
  double minimum = 0;
  double maximum = 0;
  bool minimumOpen = false;  ///< the minimum itself is out of range
  bool maximumOpen = false;
  /// May be left out in a pipeline file; then the default holds. Optional parameters are the last ones.
  bool optional = false;
  /// Left out, an optional parameter is what this earlier one is (its place); -1: its default holds.
  int follows = -1;
};

}  // namespace footfall
