// Which parameter to change so that what keeps two parts apart does so no more.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "footfall/path.hpp"
#include "ui/base/level_units.hpp"
#include "ui/document/document.hpp"

namespace footfall::ui {

struct SeparationMend {
  int filter = 0;  ///< FilterEntry::id
  std::size_t parameter = 0;
  double value = 0;  ///< environment units
  QString text;      ///< "Raise Step to 0.45 m"
  bool operator==(const SeparationMend&) const = default;
};

/// The change of one value of a filter in use that is enough for the barrier of `separation`, by at most a hundredth of
/// the shown unit more than it needs: what it needs is known as a rounded number. Nothing where no value of these
/// filters is enough (a wall), or where they allow it already.
std::optional<SeparationMend> mendOf(const Separation& separation, const std::vector<FilterEntry>& filters,
                                     const LevelUnits& units);

}  // namespace footfall::ui
