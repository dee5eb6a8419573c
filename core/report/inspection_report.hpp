// Why a place is walkable or not, in words and as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/inspect/inspection.hpp"

namespace footfall::detail {

/// For people: the place in the file's frame and units, its triangle, the slope, the free height, and the verdict with
/// the filter and the triangle responsible. Triangles are numbered from 0 in the order of the environment: what was
/// left out of the file does not count.
std::string formatExplanation(const Inspector& inspector, const PlaceExplanation& explanation);

/// The same as JSON: `point`, `triangle`, `mesh`, `material`, `slope` (null: no area), `headroom` (null: unlimited),
/// `above`, `walkable`, `verdict` (a word), `step` (place in the pipeline, from 1), `filter`, `limit`, `obstacle`,
/// `obstacle_height`, `region_area`, `walls`, `floor`, `layer`, `component` (from 1), `component_area`; null where
/// there is none.
std::string formatExplanationJson(const Inspector& inspector, const PlaceExplanation& explanation);

/// The word for a verdict in JSON, e.g. "too_low".
std::string_view verdictWord(PlaceVerdict verdict);

/// A value that is known to differ from a limit, with as many digits as it takes to see that; the same text where even
/// 17 do not tell.
std::string textBeside(double value, double limit);

}  // namespace footfall::detail
