// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/up_axis.hpp"

#include <algorithm>
#include <cctype>

namespace footfall {

std::string_view nameOf(UpAxis up) {
  switch (up) {
    case UpAxis::Y:
      return "y";
    case UpAxis::Z:
      return "z";
    case UpAxis::X:
      return "x";
    case UpAxis::NegativeY:
      return "-y";
    case UpAxis::NegativeZ:
      return "-z";
    case UpAxis::NegativeX:
      return "-x";
  }
  return "z";
}

std::string shownName(UpAxis up) {
  std::string name(nameOf(up));
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

std::optional<UpAxis> upAxisFrom(std::string_view name) {
  for (const UpAxis up : kUpAxes)
    if (name == nameOf(up) || name == shownName(up)) return up;
  return std::nullopt;
}

}  // namespace footfall
