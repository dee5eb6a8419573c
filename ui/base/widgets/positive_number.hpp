// Descriptors of positive numbers that belong to no filter, for fields like those of the filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string_view>

#include "footfall/parameter.hpp"

namespace footfall::ui {

/// A number without a unit; `label` is translated where it is shown.
inline ParameterDescriptor positiveNumber(std::string_view name, std::string_view label, double usual) {
  ParameterDescriptor number;
  number.name = name;
  number.label = label;
  number.minimum = 0;
  number.minimumOpen = true;
  number.maximum = std::numeric_limits<double>::max();
  number.defaultValue = usual;
  return number;
}

}  // namespace footfall::ui
