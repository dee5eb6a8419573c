// Why a filter removed a place, in the words of its descriptor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/filters/filter_traits.hpp"
#include "footfall/inspect.hpp"

namespace footfall::detail {

/// The removal that a verdict belongs to: that of the filter which rejected the place, else that of the filter which
/// would. Null for verdicts that no filter has, and for a filter that does not describe what it removes.
const Removal* removalOf(const Pipeline& pipeline, const PlaceExplanation& explanation);

/// The number of the place that the filter compared with its limit; empty where it is not known.
std::optional<double> measureOf(const Removal& removal, const PlaceExplanation& explanation);

/// The reason as a sentence. `measure` (empty where it is not known), `limit` and `obstacle` are written by the caller,
/// with their units.
Text reasonText(const Removal& removal, const std::string& measure, const std::string& limit,
                const std::string& obstacle);

}  // namespace footfall::detail
