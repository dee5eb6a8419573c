// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/path.hpp"

namespace footfall {
namespace {

constexpr double kUsualHeight = 2;  // metres

/// The largest value of one parameter over all enabled filters of a type; 0 without any.
double largestValue(const Pipeline& pipeline, FilterType type, std::size_t parameter = 0) {
  double largest = 0;
  for (const PipelineStep& step : pipeline.steps)
    if (step.enabled && step.filter->type == type && step.values.size() > parameter)
      largest = std::max(largest, step.values[parameter]);
  return largest;
}

double largestClearance(const Pipeline& pipeline) { return largestValue(pipeline, FilterType::VerticalClearance); }

}  // namespace

double placeReach(const Pipeline& pipeline) {
  const double clearance = largestClearance(pipeline);
  return clearance > 0 ? std::nextafter(clearance, 0.0) : std::numeric_limits<double>::infinity();
}

double agentHeight(const Pipeline& pipeline, double metresPerUnit) {
  const double clearance = largestClearance(pipeline);
  return clearance > 0 ? clearance : kUsualHeight / metresPerUnit;
}

double agentStep(const Pipeline& pipeline) { return largestValue(pipeline, FilterType::Step); }
double agentGap(const Pipeline& pipeline) { return largestValue(pipeline, FilterType::Step, 1); }

}  // namespace footfall
