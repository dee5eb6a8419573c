// The whole product of SlopeFilter and VerticalClearanceFilter against the reference.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/reference/comparison.hpp"

namespace footfall::reference {

/// States whether rounding may close slivers of the environment and with them change the number of parts.
enum class Rounding { Harmless, MayClose };

/// Runs `SlopeFilter slope`, `VerticalClearanceFilter clearance`. Returns the first disagreement in words, or an empty
/// text: the exact state passes findDifference(); the rounded mesh passes findMeshError(); its plan area is the exact
/// one but for 64 units in the last place of a square of the largest coordinate for each triangle; and, if rounding is
/// harmless, it has as many parts (by shared edges) and as long obstacle edges.
std::string checkProduct(const Environment& environment, double slope, double clearance, Rounding rounding);

}  // namespace footfall::reference
