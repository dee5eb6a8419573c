// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "core/filters/descriptor_text.hpp"
#include "core/filters/filter_traits.hpp"
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

namespace {

void addSize(AgentNumbers& numbers, AgentSize size, double value) {
  switch (size) {
    case AgentSize::MaxSlope:
      numbers.maxSlope = std::min(numbers.maxSlope.value_or(value), value);
      break;
    case AgentSize::Height:
      numbers.height = std::max(numbers.height.value_or(value), value);
      break;
    case AgentSize::Step:
      numbers.step = std::max(numbers.step, value);
      break;
    case AgentSize::Gap:
      numbers.gap = std::max(numbers.gap, value);
      break;
    case AgentSize::Radius:
      numbers.radius = std::max(numbers.radius, value);
      break;
    case AgentSize::Drop:  // exports have drops, each with its own height
      break;
  }
}

}  // namespace

AgentNumbers agentNumbers(const Pipeline& pipeline) {
  AgentNumbers numbers;
  for (const PipelineStep& step : pipeline.steps) {
    if (!step.enabled) continue;
    for (std::size_t i = 0; i < step.values.size(); ++i)
      if (const auto size = parameterUse(*step.filter, i).agentSize) addSize(numbers, *size, step.values[i]);
  }
  return numbers;
}

ExportHeader makeExportHeader(const Pipeline& pipeline) {
  Pipeline enabled = pipeline;
  std::erase_if(enabled.steps, [](const PipelineStep& step) { return !step.enabled; });
  return {formatPipeline(enabled), describeAgent(enabled), {}, agentNumbers(enabled)};
}

}  // namespace footfall
