// Numbers and triangles in explanations (footfall/report.hpp has the rest).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// A value that differs from a limit, with enough digits to show the difference; the same text where 17 digits do not
/// show it.
std::string textBeside(double value, double limit);

/// "triangle 12 (mesh door, material wood), triangle 13".
std::string triangleList(const Environment& environment, const std::vector<std::uint32_t>& triangles);

}  // namespace footfall::detail
