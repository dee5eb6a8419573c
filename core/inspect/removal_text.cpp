// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/removal_text.hpp"

#include "footfall/filter.hpp"

namespace footfall::detail {

const Removal* removalOf(const Pipeline& pipeline, const PlaceExplanation& explanation) {
  if (explanation.step) return findRemoval(*pipeline.steps[*explanation.step].filter->traits, explanation.verdict);
  if (explanation.verdict == PlaceVerdict::Removed) return nullptr;
  for (const FilterDescriptor& filter : filterDescriptors())
    if (const Removal* removal = findRemoval(*filter.traits, explanation.verdict)) return removal;
  return nullptr;
}

std::optional<double> measureOf(const Removal& removal, const PlaceExplanation& explanation) {
  switch (removal.measure) {
    case PlaceMeasure::Slope:
      return explanation.movedSlope.value_or(explanation.slope);
    case PlaceMeasure::Headroom:
      return explanation.obstacle ? std::optional(explanation.obstacle->height) : std::nullopt;
    case PlaceMeasure::RegionArea:
      return explanation.regionArea;
    case PlaceMeasure::WallDistance:
      return explanation.wallDistance;
    case PlaceMeasure::LedgeDistance:
      return explanation.ledgeDistance;
    case PlaceMeasure::None:
      break;
  }
  return std::nullopt;
}

Text reasonText(const Removal& removal, const std::string& measure, const std::string& limit,
                const std::string& obstacle) {
  const bool isUnknown = measure.empty() && removal.measure != PlaceMeasure::None;
  return {isUnknown ? removal.reasonWithoutMeasure : removal.reason, measure, limit, obstacle};
}

}  // namespace footfall::detail
