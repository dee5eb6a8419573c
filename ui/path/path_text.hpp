// The texts of the path and measure tools.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "footfall/body_path.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/level_units.hpp"

namespace footfall::ui {

/// The reason why there is no path, and the nearest place that can be reached; empty when there is a path.
QString failureText(const PathResult& result, const LevelUnits& units);
/// The reason why a body does not get where a point does.
QString bodyFailureText(const BodyPath& path, const LevelUnits& units);
/// The narrowest passage of a body's path; empty where there is none.
QString narrowestText(const BodyPath& path, const LevelUnits& units);
/// Length, time and slopes of a path, one a line. `speed` is in metres a second; drops take as long as a fall.
QString pathText(const PathResult& result, const LevelUnits& units, double speed);

}  // namespace footfall::ui
