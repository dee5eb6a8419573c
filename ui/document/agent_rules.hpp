// How agents drive filters: which parameter is which size of an agent.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "footfall/filter.hpp"
#include "ui/document/document.hpp"

namespace footfall::ui {

enum class AgentSize { Height, MaxSlope };

/// The size that the first parameter of a filter is; nothing for filters that no agent drives.
std::optional<AgentSize> agentSizeOf(const FilterDescriptor& filter);
/// The filter that a size drives, with the parameter that says what the size may be.
const FilterDescriptor& filterOf(AgentSize size);
/// In the environment's units, or in degrees.
double sizeOf(const NamedAgent& agent, AgentSize size);
void setSizeOf(NamedAgent& agent, AgentSize size, double value);

/// The one whose filters these are; null when there is none.
const NamedAgent* activeAgent(const DocumentState& state);
/// Writes the active agent's sizes into all filters that take them, those that are switched off too.
void applyAgent(DocumentState& state);
/// Whether the filters have the active agent's sizes; true without an active agent.
bool followsAgent(const DocumentState& state);
/// The same filters for another agent; nothing else is different. Unknown id: as they are.
Pipeline pipelineFor(const DocumentState& state, int agent);
/// Sizes that no filter that is switched on takes: there the agents have no effect.
std::vector<AgentSize> sizesWithoutEffect(const DocumentState& state);

/// Heights in the environment's units stay the same in metres.
std::vector<NamedAgent> rescaledAgents(std::vector<NamedAgent> agents, double fromMetresPerUnit,
                                       double toMetresPerUnit);

struct AgentPreset {
  NamedAgent agent;  ///< without an id
  QString help;      ///< in metres
};
/// Sizes of people and things that walk or roll, converted from metres.
std::vector<AgentPreset> agentPresets(double metresPerUnit);

/// For a new agent: above all that are there.
int newAgentId(const DocumentState& state);
/// `name`, or `name 2`, ... where it is taken.
std::string freeAgentName(const DocumentState& state, const std::string& name);

}  // namespace footfall::ui
