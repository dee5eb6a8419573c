// Finds the parameter whose change would connect two separate parts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "footfall/path.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/document/document.hpp"

namespace footfall::ui {

struct SeparationMend {
  int filter = 0;  ///< FilterEntry::id
  std::size_t parameter = 0;
  double value = 0;  ///< in environment units
  QString text;      ///< such as "Raise Step to 0.45 m"
  bool operator==(const SeparationMend&) const = default;
};

/// The change of one value of an enabled filter that removes the barrier of `separation`. The value exceeds the need by
/// at most a hundredth of the shown unit, because the need is a rounded number. Empty where no value of these filters
/// suffices (a wall), or where they allow the way already.
std::optional<SeparationMend> mendOf(const Separation& separation, const std::vector<FilterEntry>& filters,
                                     const LevelUnits& units);

}  // namespace footfall::ui
