// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/place_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall {

double placeReach(const Pipeline& pipeline) {
  double clearance = 0;
  for (const PipelineStep& step : pipeline.steps)
    if (step.enabled && step.filter->name == "VerticalClearanceFilter" && !step.values.empty())
      clearance = std::max(clearance, step.values[0]);
  return clearance > 0 ? std::nextafter(clearance, 0.0) : std::numeric_limits<double>::infinity();
}

}  // namespace footfall
