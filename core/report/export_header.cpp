// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "core/filters/descriptor_text.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/report.hpp"

namespace footfall {
using namespace detail;

std::string describeAgent(const Pipeline& pipeline) {
  std::string slope = "slope any";
  std::string height = "height any";
  std::optional<double> smallestSlope, largestHeight, largestStep, largestGap;
  for (const PipelineStep& step : pipeline.steps) {
    if (!step.enabled || step.values.empty()) continue;
    const ParameterDescriptor& parameter = step.filter->parameters.front();
    if (step.filter->type == FilterType::Slope) {
      smallestSlope = std::min(smallestSlope.value_or(step.values[0]), step.values[0]);
      slope = "slope " + formatValue(parameter, *smallestSlope) + " degrees";
    } else if (step.filter->type == FilterType::VerticalClearance) {
      largestHeight = std::max(largestHeight.value_or(step.values[0]), step.values[0]);
      height = "height " + formatValue(parameter, *largestHeight);
    } else if (step.filter->type == FilterType::Step) {
      largestStep = std::max(largestStep.value_or(0), step.values[0]);
      largestGap = std::max(largestGap.value_or(0), step.values[1]);
    }
  }
  const std::vector<ParameterDescriptor>& lengths = filterDescriptor(FilterType::Step).parameters;
  std::string climbs;
  if (largestStep) climbs += ", step " + formatValue(lengths[0], *largestStep);
  if (largestGap.value_or(0) > 0) climbs += ", gap " + formatValue(lengths[1], *largestGap);
  return slope + ", " + height + climbs;
}

AgentNumbers agentNumbers(const Pipeline& pipeline) {
  AgentNumbers numbers;
  for (const PipelineStep& step : pipeline.steps) {
    if (!step.enabled || step.values.empty()) continue;
    const double value = step.values[0];
    switch (step.filter->type) {
      case FilterType::Slope:
        numbers.maxSlope = std::min(numbers.maxSlope.value_or(value), value);
        break;
      case FilterType::VerticalClearance:
        numbers.height = std::max(numbers.height.value_or(value), value);
        break;
      case FilterType::Step:
        numbers.step = std::max(numbers.step, value);
        if (step.values.size() > 1) numbers.gap = std::max(numbers.gap, step.values[1]);
        break;
      case FilterType::Radius:
        numbers.radius = std::max(numbers.radius, value);
        break;
      default:
        break;
    }
  }
  return numbers;
}

ExportHeader makeExportHeader(const Pipeline& pipeline) {
  Pipeline enabled = pipeline;
  std::erase_if(enabled.steps, [](const PipelineStep& step) { return !step.enabled; });
  return {formatPipeline(enabled), describeAgent(enabled), {}, agentNumbers(enabled)};
}

}  // namespace footfall
