// Which parameter of which filter is which size of an agent.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/filters/filter_traits.hpp"
#include "footfall/parameter.hpp"
#include "ui/document/document.hpp"

namespace footfall::ui {

using detail::AgentSize;
inline constexpr std::array kAgentSizes{AgentSize::Height, AgentSize::MaxSlope, AgentSize::Step,
                                        AgentSize::Gap,    AgentSize::Radius,   AgentSize::Drop};
/// Returns whether a size may be 0, which means no filter for it.
constexpr bool mayBeNone(AgentSize size) {
  return size == AgentSize::Step || size == AgentSize::Radius || size == AgentSize::Drop;
}

/// The size that a parameter of a filter stands for; empty for parameters that no agent sets.
std::optional<AgentSize> agentSizeOf(const FilterDescriptor& filter, std::size_t parameter = 0);
/// The filter that a size sets.
const FilterDescriptor& filterOf(AgentSize size);
/// What a size may be: the parameter of its filter, and 0 where the agent may have none.
ParameterDescriptor parameterOf(AgentSize size);
/// In the environment's units, or in degrees.
double sizeOf(const NamedAgent& agent, AgentSize size);
void setSizeOf(NamedAgent& agent, AgentSize size, double value);

/// The agent whose sizes the filters have; null when there is none.
const NamedAgent* activeAgent(const DocumentState& state);
/// Writes the active agent's sizes into all filters that have them, including filters that are off. A filter whose
/// step, radius or drop would be 0 does not change. A value that follows a size, as the distance to ledges follows the
/// radius, changes with it where both were equal.
void writeSizes(DocumentState& state);
/// Writes the sizes, and adds or removes filters. Enabled filters are removed for steps, radii and drops that the agent
/// does not have. Where it has them and there is no filter, one with an id of `newId` is added: for steps and drops as
/// far in front as allowed (nowhere without a clearance before it), for a radius behind the filters that it must
/// follow.
void applyAgent(DocumentState& state, const std::function<int()>& newId);
/// Returns whether the filters have the active agent's sizes; true without an active agent.
bool followsAgent(const DocumentState& state);
/// The filters after switching to that agent. They do not change for the active agent or an unknown id.
Pipeline pipelineFor(const DocumentState& state, int agent);
/// The sizes that no enabled filter uses, so that they have no effect. Steps, radii and drops, whose filters are added
/// and removed by switching agents, count only where the active agent has them.
std::vector<AgentSize> sizesWithoutEffect(const DocumentState& state);
/// The reason why applyAgent() cannot add a filter for a size: a problem of the list, or of the filter at its end.
/// Empty where it can, and for sizes that have a filter, even one that is off.
Text whyNoPlace(const DocumentState& state, AgentSize size);

/// Converts the agents so that their lengths stay the same in metres.
std::vector<NamedAgent> rescaledAgents(std::vector<NamedAgent> agents, double fromMetresPerUnit,
                                       double toMetresPerUnit);

struct AgentPreset {
  NamedAgent agent;  ///< without an id
  QString help;      ///< in metres
};
/// Sizes of people and of walking or rolling machines, and the default agents of other navigation meshes, converted
/// from metres.
std::vector<AgentPreset> agentPresets(double metresPerUnit);

/// The id of a new agent, larger than all present ids.
int newAgentId(const DocumentState& state);
/// Returns `name`, or `name 2`, ... where it is taken.
std::string freeAgentName(const DocumentState& state, const std::string& name);

}  // namespace footfall::ui
