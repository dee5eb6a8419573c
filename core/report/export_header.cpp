// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/filters/descriptor_text.hpp"
#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/report.hpp"

namespace footfall {
using namespace detail;

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

std::string describeAgent(const Pipeline& pipeline) {
  const AgentNumbers numbers = agentNumbers(pipeline);
  const auto shown = [](AgentSize size, double value) {
    const DrivenParameter driven = drivenBy(size);
    return formatValue(driven.filter->parameters[driven.parameter], value);
  };
  std::string text = "slope " + (numbers.maxSlope ? shown(AgentSize::MaxSlope, *numbers.maxSlope) + " degrees" : "any");
  text += ", height " + (numbers.height ? shown(AgentSize::Height, *numbers.height) : "any");
  if (numbers.step > 0) text += ", step " + shown(AgentSize::Step, numbers.step);
  if (numbers.gap > 0) text += ", gap " + shown(AgentSize::Gap, numbers.gap);
  if (numbers.radius > 0) text += ", radius " + shown(AgentSize::Radius, numbers.radius);
  return text;
}

ExportHeader makeExportHeader(const Pipeline& pipeline) {
  Pipeline enabled = pipeline;
  std::erase_if(enabled.steps, [](const PipelineStep& step) { return !step.enabled; });
  return {formatPipeline(enabled), describeAgent(enabled), {}, agentNumbers(enabled)};
}

}  // namespace footfall
