// What the path and measure tools say in words and numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "footfall/path.hpp"
#include "ui/base/level_units.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// Why there is no path, and how near one can come; empty when there is one.
QString failureText(const PathResult& result, const LevelUnits& units);
/// Length, time and slopes of a path, one a line. `speed` is in metres a second.
QString pathText(const PathResult& result, const LevelUnits& units, double speed);

}  // namespace footfall::ui
