// What the path and measure tools say in words and numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/navigation/path_finder.hpp"

namespace footfall {

/// Up to six digits, without exponents for what levels measure.
QString measureText(double value);
/// A place as "x, y, z".
QString placeText(const Vec3& place);
/// Why there is no path, and how near one can come; empty when there is one.
QString failureText(const PathResult& result);
/// Length, time and slopes of a path, one a line. `speed` is in metres a second.
QString pathText(const PathResult& result, double metresPerUnit, double speed);

}  // namespace footfall
