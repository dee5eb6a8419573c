// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/agent_rules.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "core/pipeline/block_structure.hpp"
#include "footfall/agent.hpp"
#include "footfall/filter.hpp"
#include "ui/base/text/translated.hpp"

namespace footfall::ui {
namespace {

// Rounds to twelve digits: 40 and not 40.000000000000007, which a change of scale and back would leave.
double rounded(double value) {
  std::array<char, 40> digits{};
  std::snprintf(digits.data(), digits.size(), "%.12g", value);
  return std::strtod(digits.data(), nullptr);
}

bool isOn(const FilterEntry& entry, AgentSize size) {
  return entry.step.enabled && agentSizeOf(*entry.step.filter) == size;
}

Pipeline pipelineOf(const std::vector<FilterEntry>& filters) {
  Pipeline pipeline;
  for (const FilterEntry& entry : filters) pipeline.steps.push_back(entry.step);
  return pipeline;
}

/// Behind all that makes borders or would lose drops, and in front of the filters that go by links and drops. Where it
/// has no place, nothing changes, and what is wrong with it at the end is returned.
Text insertEarly(std::vector<FilterEntry>& filters, const FilterEntry& added) {
  const auto last = std::find_if(filters.rbegin(), filters.rend(), [](const FilterEntry& entry) {
    return entry.step.enabled && entry.step.filter->traits->makesBorders(entry.step.values);
  });
  for (auto at = last.base();; ++at) {
    std::vector<FilterEntry> with(filters.begin(), at);
    with.push_back(added);
    with.insert(with.end(), at, filters.end());
    const auto error = findStructureError(pipelineOf(with));
    if (!error) {
      filters = std::move(with);
      return {};
    }
    if (at == filters.end()) return error->message;
  }
}

/// Inserts a radius behind the filters that it must follow, in front of drops, which it would lose, and in front of
/// filters that evaluate what is left.
void insertRadius(std::vector<FilterEntry>& filters, const FilterEntry& radius) {
  const auto last = std::find_if(filters.rbegin(), filters.rend(), [](const FilterEntry& entry) {
    const auto size = agentSizeOf(*entry.step.filter);
    return entry.step.enabled && ((size && size != AgentSize::Drop) || entry.step.filter->kind != FilterKind::Filter);
  });
  filters.insert(last.base(), radius);
}

}  // namespace

std::optional<AgentSize> agentSizeOf(const FilterDescriptor& filter, std::size_t parameter) {
  return parameterUse(filter, parameter).agentSize;
}

const FilterDescriptor& filterOf(AgentSize size) { return *drivenBy(size).filter; }

ParameterDescriptor parameterOf(AgentSize size) {
  const auto [filter, place] = drivenBy(size);
  ParameterDescriptor parameter = filter->parameters[place];
  if (mayBeNone(size)) parameter.minimumOpen = false;
  return parameter;
}

double sizeOf(const NamedAgent& agent, AgentSize size) {
  switch (size) {
    case AgentSize::Height:
      return agent.height;
    case AgentSize::MaxSlope:
      return agent.maxSlope;
    case AgentSize::Gap:
      return agent.gap;
    case AgentSize::Radius:
      return agent.radius;
    case AgentSize::Drop:
      return agent.drop;
    case AgentSize::Step:
      break;
  }
  return agent.step;
}

void setSizeOf(NamedAgent& agent, AgentSize size, double value) {
  switch (size) {
    case AgentSize::Height:
      agent.height = value;
      break;
    case AgentSize::MaxSlope:
      agent.maxSlope = value;
      break;
    case AgentSize::Step:
      agent.step = value;
      break;
    case AgentSize::Gap:
      agent.gap = value;
      break;
    case AgentSize::Radius:
      agent.radius = value;
      break;
    case AgentSize::Drop:
      agent.drop = value;
      break;
  }
}

const NamedAgent* activeAgent(const DocumentState& state) {
  const auto found = std::ranges::find(state.agents, state.agent, &NamedAgent::id);
  return found == state.agents.end() ? nullptr : &*found;
}

void writeSizes(DocumentState& state) {
  const NamedAgent* agent = activeAgent(state);
  if (!agent) return;
  for (FilterEntry& entry : state.filters) {
    std::vector<double>& values = entry.step.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto size = agentSizeOf(*entry.step.filter, i);
      if (!size || (mayBeNone(*size) && sizeOf(*agent, *size) == 0)) continue;
      const double value = sizeOf(*agent, *size), before = std::exchange(values[i], value);
      for (std::size_t k = i + 1; k < values.size(); ++k) {
        if (entry.step.filter->parameters[k].follows == static_cast<int>(i) && values[k] == before) values[k] = value;
      }
    }
  }
}

void applyAgent(DocumentState& state, const std::function<int()>& newId) {
  const NamedAgent* agent = activeAgent(state);
  if (!agent) return;
  for (const AgentSize size : {AgentSize::Step, AgentSize::Radius, AgentSize::Drop}) {
    const FilterDescriptor& filter = filterOf(size);
    if (sizeOf(*agent, size) == 0) {
      // A radius of 0 with a distance to ledges does not stand for an agent, and stays.
      std::erase_if(state.filters, [size](const FilterEntry& entry) {
        return isOn(entry, size) && !(size == AgentSize::Radius && entry.step.values[0] == 0);
      });
    } else if (std::ranges::none_of(state.filters, [&](const FilterEntry& e) { return e.step.filter == &filter; })) {
      const FilterEntry added{newId(), defaultStep(filter, 1)};
      if (size == AgentSize::Radius)
        insertRadius(state.filters, added);
      else
        (void)insertEarly(state.filters, added);  // whyNoPlace() gives the panel the reason where that fails
    }
  }
  writeSizes(state);
}

bool followsAgent(const DocumentState& state) {
  const NamedAgent* agent = activeAgent(state);
  return !agent || std::ranges::all_of(state.filters, [agent](const FilterEntry& entry) {
    for (std::size_t i = 0; i < entry.step.values.size(); ++i) {
      const auto size = agentSizeOf(*entry.step.filter, i);
      if (size && mayBeNone(*size) && sizeOf(*agent, *size) == 0)
        return !entry.step.enabled || entry.step.values[i] == 0;
      if (size && entry.step.values[i] != sizeOf(*agent, *size)) return false;
    }
    return true;
  });
}

Pipeline pipelineFor(const DocumentState& state, int agent) {
  DocumentState other;
  other.filters = state.filters;
  other.agents = state.agents;
  other.agent = agent;
  if (agent != state.agent) applyAgent(other, [] { return 0; });
  return pipelineOf(other.filters);
}

std::vector<AgentSize> sizesWithoutEffect(const DocumentState& state) {
  std::vector<AgentSize> missing;
  const NamedAgent* active = activeAgent(state);
  for (const AgentSize size :
       {AgentSize::MaxSlope, AgentSize::Height, AgentSize::Step, AgentSize::Radius, AgentSize::Drop}) {
    if (mayBeNone(size) && (!active || sizeOf(*active, size) == 0)) continue;
    if (std::ranges::none_of(state.filters, [size](const FilterEntry& entry) { return isOn(entry, size); }))
      missing.push_back(size);
  }
  return missing;
}

Text whyNoPlace(const DocumentState& state, AgentSize size) {
  const FilterDescriptor& filter = filterOf(size);
  const bool isThere =
      std::ranges::any_of(state.filters, [&](const FilterEntry& e) { return e.step.filter == &filter; });
  if (isThere || !mayBeNone(size) || size == AgentSize::Radius) return {};
  std::vector<FilterEntry> filters = state.filters;
  return insertEarly(filters, {0, defaultStep(filter, 1)});
}

std::vector<NamedAgent> rescaledAgents(std::vector<NamedAgent> agents, double fromMetresPerUnit,
                                       double toMetresPerUnit) {
  for (NamedAgent& agent : agents) {
    for (double* length : {&agent.height, &agent.step, &agent.gap, &agent.radius, &agent.drop})
      *length = rounded(*length * fromMetresPerUnit / toMetresPerUnit);
  }
  return agents;
}

// The sizes have sources in core/pipeline/known_agents.cpp. No preset drops: in Unity, which supports drops, objects
// are marked for them first.
std::vector<AgentPreset> agentPresets(double metresPerUnit) {
  const auto preset = [metresPerUnit](const char* known, const QString& name, const QString& help) {
    const auto units = [metresPerUnit](double metres) { return rounded(metres / metresPerUnit); };
    const Agent& agent = std::ranges::find(knownAgents(), std::string_view(known), &KnownAgent::name)->agent;
    return AgentPreset{{0, name.toStdString(), units(agent.height), agent.maxSlope, units(agent.step), units(agent.gap),
                        units(agent.radius), 0},
                       help};
  };
  return {
      preset(
          "Human", tr("Human"),
          tr("2 m, slopes up to 45°, stairs: risers up to 0.22 m, gaps up to 0.05 m, shoulders: a radius of 0.27 m")),
      preset("Child", tr("Child"),
             tr("1.2 m, slopes up to 45°, stairs: risers up to 0.22 m, gaps up to 0.05 m, a radius of 0.18 m")),
      preset("Wheelchair", tr("Wheelchair"),
             tr("1.5 m, slopes up to 5° (ramps of 1 in 12 are 4.76°), thresholds and gaps up to 0.013 m, a radius of "
                "0.38 m")),
      preset("Cart", tr("Cart"), tr("1.2 m, slopes up to 10°, thresholds and gaps up to 0.013 m, a radius of 0.3 m")),
      preset("Giant", tr("Giant"), tr("4 m, slopes up to 45°, steps up to 0.8 m, gaps up to 0.1 m, a radius of 1 m")),
      preset("Crawler", tr("Crawler"),
             tr("0.5 m, slopes up to 60°, steps up to 0.1 m, gaps up to 0.02 m, a radius of 0.2 m")),
      preset("Robot", tr("Robot"),
             tr("A robot on four legs: 0.84 m, slopes up to 30°, steps up to 0.3 m, gaps up to 0.05 m, a radius of "
                "0.25 m")),
      preset("Unity", QStringLiteral("Unity"),
             tr("Unity's default: 2 m, slopes up to 45°, steps up to 0.75 m, a radius of 0.5 m")),
      preset("Unreal", QStringLiteral("Unreal"),
             tr("Unreal's default: 1.44 m, slopes up to 44°, steps up to 0.35 m, a radius of 0.34 m")),
      preset("Godot", QStringLiteral("Godot"),
             tr("Godot's default: 1.5 m, slopes up to 45°, steps up to 0.25 m, a radius of 0.5 m")),
      preset("Recast", QStringLiteral("Recast"),
             tr("The default of Recast's demo: 2 m, slopes up to 45°, steps up to 0.9 m, a radius of 0.6 m"))};
}

int newAgentId(const DocumentState& state) {
  int highest = 0;
  for (const NamedAgent& agent : state.agents) highest = std::max(highest, agent.id);
  return highest + 1;
}

std::string freeAgentName(const DocumentState& state, const std::string& name) {
  std::string free = name;
  for (int i = 2; std::ranges::find(state.agents, free, &NamedAgent::name) != state.agents.end(); ++i)
    free = name + ' ' + std::to_string(i);
  return free;
}

}  // namespace footfall::ui
