// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "footfall/path.hpp"

namespace footfall {
namespace {

constexpr double kUsualHeight = 2;  // metres

double largestClearance(const Pipeline& pipeline) {
  double clearance = 0;
  for (const PipelineStep& step : pipeline.steps)
    if (step.enabled && step.filter->type == FilterType::VerticalClearance && !step.values.empty())
      clearance = std::max(clearance, step.values[0]);
  return clearance;
}

}  // namespace

double placeReach(const Pipeline& pipeline) {
  const double clearance = largestClearance(pipeline);
  return clearance > 0 ? std::nextafter(clearance, 0.0) : std::numeric_limits<double>::infinity();
}

double agentHeight(const Pipeline& pipeline, double metresPerUnit) {
  const double clearance = largestClearance(pipeline);
  return clearance > 0 ? clearance : kUsualHeight / metresPerUnit;
}

}  // namespace footfall
