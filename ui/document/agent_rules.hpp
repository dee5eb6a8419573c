// How agents drive filters: which parameter is which size of an agent.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "footfall/filter.hpp"
#include "ui/document/document.hpp"

namespace footfall::ui {

enum class AgentSize { Height, MaxSlope, Step, Gap, Radius, Drop };
inline constexpr std::array kAgentSizes{AgentSize::Height, AgentSize::MaxSlope, AgentSize::Step,
                                        AgentSize::Gap,    AgentSize::Radius,   AgentSize::Drop};
/// Whether 0 means that the agent has none of it, and no filter for it.
constexpr bool mayBeNone(AgentSize size) {
  return size == AgentSize::Step || size == AgentSize::Radius || size == AgentSize::Drop;
}

/// The size that a parameter of a filter is; nothing for those that no agent drives.
std::optional<AgentSize> agentSizeOf(const FilterDescriptor& filter, std::size_t parameter = 0);
/// The filter that a size drives.
const FilterDescriptor& filterOf(AgentSize size);
/// What a size may be: the parameter of its filter, and 0 where the agent may have none.
const ParameterDescriptor& parameterOf(AgentSize size);
/// In the environment's units, or in degrees.
double sizeOf(const NamedAgent& agent, AgentSize size);
void setSizeOf(NamedAgent& agent, AgentSize size, double value);

/// The one whose filters these are; null when there is none.
const NamedAgent* activeAgent(const DocumentState& state);
/// Writes the active agent's sizes into all filters that take them, those that are switched off too. A step, a
/// radius or a drop of 0 is no value for a filter: those stay. What follows a size, as the distance to ledges the
/// radius, goes with it where both were the same.
void writeSizes(DocumentState& state);
/// The same, and where the agent climbs no steps, has no radius or does not drop, filters for that which are on go;
/// where it does and there is none, one with an id of `newId` comes: for steps and drops as far in front as it may
/// stand (nowhere without a clearance before it), for a radius behind the filters that it must follow.
void applyAgent(DocumentState& state, const std::function<int()>& newId);
/// Whether the filters have the active agent's sizes; true without an active agent.
bool followsAgent(const DocumentState& state);
/// What switching to that agent would make of the filters. The active one or an unknown id: as they are.
Pipeline pipelineFor(const DocumentState& state, int agent);
/// Sizes that no filter that is switched on takes: there the agents have no effect. Steps, radii and drops, which
/// switching between agents adds and removes, only where the active agent has some.
std::vector<AgentSize> sizesWithoutEffect(const DocumentState& state);
/// Why applyAgent() cannot put a filter for a size into the list: what is wrong with the list, or with the filter at
/// its end. Empty where it can, and for sizes that have a filter, which may be off.
Text whyNoPlace(const DocumentState& state, AgentSize size);

/// Lengths in the environment's units stay the same in metres.
std::vector<NamedAgent> rescaledAgents(std::vector<NamedAgent> agents, double fromMetresPerUnit,
                                       double toMetresPerUnit);

struct AgentPreset {
  NamedAgent agent;  ///< without an id
  QString help;      ///< in metres
};
/// Sizes of people and things that walk or roll, and what navigation meshes of others are made for unless somebody says
/// otherwise, converted from metres.
std::vector<AgentPreset> agentPresets(double metresPerUnit);

/// The id of a new agent: above all that are there.
int newAgentId(const DocumentState& state);
/// `name`, or `name 2`, ... where it is taken.
std::string freeAgentName(const DocumentState& state, const std::string& name);

}  // namespace footfall::ui
