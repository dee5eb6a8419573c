// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/pipeline.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/filters/descriptor_text.hpp"
#include "footfall/agent.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall {
using namespace detail;
namespace {

/// The factor of a radius: who drops crosses the margin of the ledge and that of the floor below, each with its
/// tolerance of 1 %.
constexpr double kReachOverMargins = 2.1;

// 2 m in units of 0.3 mm is 6666.66666667, not 6666.666666666667: defaults are for people to read.
double roundForPeople(double value) {
  std::array<char, 32> buffer;
  const auto written =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 12);
  double rounded = value;
  std::from_chars(buffer.data(), written.ptr, rounded);
  return rounded;
}

/// A length or area in metres as one in units; anything else stays as it is.
double inUnits(const ParameterDescriptor& parameter, double value, double metresPerUnit) {
  const double unitsPerMetre = 1 / metresPerUnit;
  if (parameter.unit == Unit::Length) return roundForPeople(value * unitsPerMetre);
  if (parameter.unit == Unit::Area) return roundForPeople(value * unitsPerMetre * unitsPerMetre);
  return value;
}

double defaultInUnits(const ParameterDescriptor& parameter, double metresPerUnit) {
  const double value = inUnits(parameter, parameter.defaultValue, metresPerUnit);
  // A scale that takes the default out of range (or is no scale at all) must not make an invalid step.
  return checkValue(parameter, value).empty() ? value : parameter.defaultValue;
}

/// A number of an agent, in metres or degrees, and the filter's parameter that it becomes.
struct AgentNumber {
  std::string_view name;
  FilterType type{};
  std::size_t parameter = 0;
  double value = 0;

  [[nodiscard]] const ParameterDescriptor& descriptor() const { return filterDescriptor(type).parameters[parameter]; }
};

// The numbers of an agent that its pipeline uses.
std::vector<AgentNumber> numbersOf(const Agent& agent) {
  std::vector<AgentNumber> numbers{{"max_slope", FilterType::Slope, 0, agent.maxSlope},
                                   {"height", FilterType::VerticalClearance, 0, agent.height},
                                   {"minimum_area", FilterType::Area, 0, agent.minimumArea}};
  if (agent.step != 0) {
    numbers.push_back({"step", FilterType::Step, 0, agent.step});
    numbers.push_back({"gap", FilterType::Step, 1, agent.gap});
  }
  if (agent.radius != 0) numbers.push_back({"radius", FilterType::Radius, 0, agent.radius});
  if (agent.drop != 0) {
    numbers.push_back({"drop", FilterType::Drop, 0, agent.drop});
    const double reach = kReachOverMargins * agent.radius;
    if (reach > filterDescriptor(FilterType::Drop).parameters[1].defaultValue)
      numbers.push_back({"radius", FilterType::Drop, 1, reach});
  }
  return numbers;
}

/// The fault of an agent's number, in metres and degrees; empty: none.
Text checkNumber(const AgentNumber& number) {
  ParameterDescriptor parameter = number.descriptor();
  const Unit unit = parameter.unit;
  parameter.name = number.name;
  if (unit == Unit::Length || unit == Unit::Area) parameter.unit = Unit::None;  // the range is in metres
  const Text wrong = checkValue(parameter, number.value);
  if (wrong.empty()) return {};
  if (unit == Unit::Length) return {FOOTFALL_TEXT("agent: %1, in metres"), wrong};
  if (unit == Unit::Area) return {FOOTFALL_TEXT("agent: %1, in square metres"), wrong};
  return {FOOTFALL_TEXT("agent: %1"), wrong};
}

}  // namespace

std::string formatStep(const PipelineStep& step) {
  const std::vector<ParameterDescriptor>& parameters = step.filter->parameters;
  std::size_t written = step.values.size();
  const auto isUsual = [&](std::size_t i) {
    const int follows = parameters[i].follows;
    return parameters[i].optional &&
           step.values[i] == (follows < 0 ? parameters[i].defaultValue : step.values[follows]);
  };
  while (written > 0 && step.filter->repeats == 0 && isUsual(written - 1)) --written;
  std::string text(step.filter->name);
  for (std::size_t i = 0; i < written; ++i) text += ' ' + formatValue(step.filter->parameterOf(i), step.values[i]);
  return text;
}

std::string formatPipeline(const Pipeline& pipeline) {
  std::string text;
  for (const PipelineStep& step : pipeline.steps) text += (step.enabled ? "" : "#off ") + formatStep(step) + '\n';
  return text;
}

PipelineStep defaultStep(const FilterDescriptor& filter, double metresPerUnit) {
  PipelineStep step;
  step.filter = &filter;
  for (std::size_t i = 0; i + filter.repeats < filter.parameters.size(); ++i)
    step.values.push_back(defaultInUnits(filter.parameters[i], metresPerUnit));
  return step;
}

Text checkValue(const ParameterDescriptor& parameter, double value) {
  const std::string_view name = parameter.name;
  if (!std::isfinite(value))
    return {FOOTFALL_TEXT("%1 is not a finite number; give %2"), name, describeRange(parameter)};
  if (parameter.type != ParameterType::Real && value != std::floor(value))
    return {FOOTFALL_TEXT("%1 is not a whole number; give %2"), name, describeRange(parameter)};
  const bool above = parameter.minimumOpen ? value > parameter.minimum : value >= parameter.minimum;
  const bool below = parameter.maximumOpen ? value < parameter.maximum : value <= parameter.maximum;
  if (!above || !below) {
    ParameterDescriptor plain = parameter;  // an integer field shows a number of any size in its shortest form
    plain.type = ParameterType::Real;
    return {FOOTFALL_TEXT("%1 %2 is out of range; give %3"), name, formatValue(plain, value), describeRange(parameter)};
  }
  return {};
}

Pipeline defaultPipeline(const Environment& environment) {
  Pipeline pipeline;
  for (const FilterType type :
       {FilterType::Duplication, FilterType::Degeneracy, FilterType::Slope, FilterType::VerticalClearance,
        FilterType::Step, FilterType::Area, FilterType::Simplification, FilterType::LayerSubdivision})
    pipeline.steps.push_back(defaultStep(filterDescriptor(type), environment.metresPerUnit));
  return pipeline;
}

Pipeline pipelineFor(const Environment& environment, const Agent& agent) {
  checkAgent(agent);
  Pipeline pipeline = defaultPipeline(environment);
  const auto place = [&](FilterType type) {
    return std::ranges::find(pipeline.steps, &filterDescriptor(type), &PipelineStep::filter);
  };
  if (agent.step == 0) pipeline.steps.erase(place(FilterType::Step));
  if (agent.radius != 0) {
    pipeline.steps.insert(place(FilterType::Area),
                          defaultStep(filterDescriptor(FilterType::Radius), environment.metresPerUnit));
  }
  if (agent.drop != 0)
    pipeline.steps.push_back(defaultStep(filterDescriptor(FilterType::Drop), environment.metresPerUnit));
  for (const AgentNumber& number : numbersOf(agent)) {
    const FilterDescriptor& filter = filterDescriptor(number.type);
    const ParameterDescriptor& parameter = number.descriptor();
    std::vector<double>& values = place(number.type)->values;
    double& written = values[number.parameter];
    written = inUnits(parameter, number.value, environment.metresPerUnit);
    if (const Text wrong = checkValue(parameter, written); !wrong.empty())
      throw InputError(FOOTFALL_TEXT("agent, in the environment's units: %1"), wrong);
    for (std::size_t i = 0; i < filter.parameters.size(); ++i)
      if (filter.parameters[i].follows == static_cast<int>(number.parameter)) values[i] = written;
  }
  return pipeline;
}

void checkAgent(const Agent& agent) {
  std::vector<AgentNumber> numbers = numbersOf(agent);
  if (agent.step == 0) numbers.push_back({"gap", FilterType::Step, 1, agent.gap});
  for (const AgentNumber& number : numbers)
    if (const Text wrong = checkNumber(number); !wrong.empty()) throw InputError(wrong);
}

}  // namespace footfall
