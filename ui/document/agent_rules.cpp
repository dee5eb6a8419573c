// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/agent_rules.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace footfall::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("footfall::ui", text); }

// Twelve digits: 40 and not 40.000000000000007, which is what a change of scale and back would leave.
double rounded(double value) {
  std::array<char, 40> digits{};
  std::snprintf(digits.data(), digits.size(), "%.12g", value);
  return std::strtod(digits.data(), nullptr);
}

}  // namespace

std::optional<AgentSize> agentSizeOf(const FilterDescriptor& filter) {
  if (filter.type == FilterType::Slope) return AgentSize::MaxSlope;
  if (filter.type == FilterType::VerticalClearance) return AgentSize::Height;
  return std::nullopt;
}

const FilterDescriptor& filterOf(AgentSize size) {
  return filterDescriptor(size == AgentSize::Height ? FilterType::VerticalClearance : FilterType::Slope);
}

double sizeOf(const NamedAgent& agent, AgentSize size) {
  return size == AgentSize::Height ? agent.height : agent.maxSlope;
}

void setSizeOf(NamedAgent& agent, AgentSize size, double value) {
  (size == AgentSize::Height ? agent.height : agent.maxSlope) = value;
}

const NamedAgent* activeAgent(const DocumentState& state) {
  const auto found = std::ranges::find(state.agents, state.agent, &NamedAgent::id);
  return found == state.agents.end() ? nullptr : &*found;
}

void applyAgent(DocumentState& state) {
  const NamedAgent* agent = activeAgent(state);
  if (!agent) return;
  for (FilterEntry& entry : state.filters) {
    if (const auto size = agentSizeOf(*entry.step.filter)) entry.step.values[0] = sizeOf(*agent, *size);
  }
}

bool followsAgent(const DocumentState& state) {
  const NamedAgent* agent = activeAgent(state);
  return !agent || std::ranges::all_of(state.filters, [agent](const FilterEntry& entry) {
    const auto size = agentSizeOf(*entry.step.filter);
    return !size || entry.step.values[0] == sizeOf(*agent, *size);
  });
}

Pipeline pipelineFor(const DocumentState& state, int agent) {
  DocumentState other;
  other.filters = state.filters;
  other.agents = state.agents;
  other.agent = agent;
  applyAgent(other);
  Pipeline pipeline;
  for (const FilterEntry& entry : other.filters) pipeline.steps.push_back(entry.step);
  return pipeline;
}

std::vector<AgentSize> sizesWithoutEffect(const DocumentState& state) {
  std::vector<AgentSize> missing;
  for (const AgentSize size : {AgentSize::MaxSlope, AgentSize::Height}) {
    const bool driven = std::ranges::any_of(state.filters, [size](const FilterEntry& entry) {
      return entry.step.enabled && agentSizeOf(*entry.step.filter) == size;
    });
    if (!driven) missing.push_back(size);
  }
  return missing;
}

std::vector<NamedAgent> rescaledAgents(std::vector<NamedAgent> agents, double fromMetresPerUnit,
                                       double toMetresPerUnit) {
  for (NamedAgent& agent : agents) agent.height = rounded(agent.height * fromMetresPerUnit / toMetresPerUnit);
  return agents;
}

std::vector<AgentPreset> agentPresets(double metresPerUnit) {
  const auto preset = [metresPerUnit](const QString& name, double metres, double degrees, const QString& help) {
    return AgentPreset{{0, name.toStdString(), rounded(metres / metresPerUnit), degrees}, help};
  };
  return {preset(tr("Human"), 2, 45, tr("2 m, stairs and slopes up to 45°")),
          preset(tr("Child"), 1.2, 45, tr("1.2 m, stairs and slopes up to 45°")),
          preset(tr("Wheelchair"), 1.5, 5, tr("1.5 m, slopes up to 5°: ramps of 1 in 12 are 4.76°")),
          preset(tr("Cart"), 1.2, 10, tr("1.2 m, slopes up to 10°")),
          preset(tr("Giant"), 4, 45, tr("4 m, slopes up to 45°")),
          preset(tr("Crawler"), 0.5, 60, tr("0.5 m, slopes up to 60°"))};
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
