// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/agents/agent_edits.hpp"

#include <algorithm>
#include <utility>

#include "ui/base/text/translated.hpp"
#include "ui/document/edit_text.hpp"

namespace footfall::ui {
namespace {

QString nameOf(const NamedAgent& agent) { return QString::fromStdString(agent.name); }

std::vector<NamedAgent>::iterator find(DocumentState& state, int id) {
  return std::ranges::find(state.agents, id, &NamedAgent::id);
}

QString resizeText(AgentSize size) {
  switch (size) {
    case AgentSize::Height:
      return tr("Change height of %1 %2 → %3");
    case AgentSize::MaxSlope:
      return tr("Change maximum slope of %1 %2 → %3");
    case AgentSize::Gap:
      return tr("Change gap of %1 %2 → %3");
    case AgentSize::Radius:
      return tr("Change radius of %1 %2 → %3");
    case AgentSize::Drop:
      return tr("Change drop of %1 %2 → %3");
    case AgentSize::Step:
      break;
  }
  return tr("Change step of %1 %2 → %3");
}

}  // namespace

int addAgent(Document& document, const NamedAgent& agent) {
  DocumentState next = document.state();
  next.agents.push_back(agent);
  NamedAgent& added = next.agents.back();
  added.id = newAgentId(document.state());
  added.name = freeAgentName(document.state(), agent.name);
  next.agent = added.id;
  const int id = added.id;
  const QString text = tr("Add agent %1").arg(nameOf(added));
  applyAgent(next, [&document] { return document.newFilterId(); });
  document.edit(std::move(next), text);
  return id;
}

int duplicateAgent(Document& document, int id) {
  DocumentState next = document.state();
  const auto at = find(next, id);
  if (at == next.agents.end()) return 0;
  NamedAgent copy = *at;
  copy.id = newAgentId(document.state());
  copy.name = freeAgentName(document.state(), copy.name);
  next.agents.insert(at + 1, copy);
  next.agent = copy.id;
  applyAgent(next, [&document] { return document.newFilterId(); });
  document.edit(std::move(next), tr("Duplicate agent %1").arg(nameOf(copy)));
  return copy.id;
}

void removeAgent(Document& document, int id) {
  DocumentState next = document.state();
  const auto at = find(next, id);
  if (at == next.agents.end()) return;
  const QString name = nameOf(*at);
  next.agents.erase(at);
  document.edit(std::move(next), tr("Remove agent %1").arg(name));
}

void renameAgent(Document& document, int id, const QString& name) {
  DocumentState next = document.state();
  const auto at = find(next, id);
  const QString trimmed = name.simplified();
  if (at == next.agents.end() || trimmed.isEmpty() || trimmed == nameOf(*at)) return;
  const QString before = nameOf(*at);
  DocumentState others = document.state();
  std::erase_if(others.agents, [id](const NamedAgent& agent) { return agent.id == id; });
  at->name = freeAgentName(others, trimmed.toStdString());
  const QString now = nameOf(*at);
  document.edit(std::move(next), tr("Rename agent %1 → %2").arg(before, now));
}

void resizeAgent(Document& document, int id, AgentSize size, double value) {
  DocumentState next = document.state();
  const auto at = find(next, id);
  if (at == next.agents.end()) return;
  const ParameterDescriptor& parameter = parameterOf(size);
  const QString text = resizeText(size).arg(nameOf(*at), valueText(parameter, sizeOf(*at, size), document.units()),
                                            valueText(parameter, value, document.units()));
  setSizeOf(*at, size, value);
  applyAgent(next, [&document] { return document.newFilterId(); });
  document.edit(std::move(next), text);
}

void activateAgent(Document& document, int id) {
  DocumentState next = document.state();
  next.agent = id;
  const NamedAgent* agent = activeAgent(next);
  applyAgent(next, [&document] { return document.newFilterId(); });
  const QString text = agent ? tr("Switch to agent %1").arg(nameOf(*agent)) : tr("Deactivate the agent");
  document.edit(std::move(next), text, QStringLiteral("agent"));
}

NamedAgent agentOfFilters(const DocumentState& state, double metresPerUnit) {
  NamedAgent agent = agentPresets(metresPerUnit).front().agent;
  agent.name = tr("Agent").toStdString();
  agent.step = agent.radius = agent.drop = 0;
  for (const AgentSize size : kAgentSizes) {
    const std::size_t parameter = size == AgentSize::Gap ? 1 : 0;
    for (const FilterEntry& entry : state.filters) {
      if (agentSizeOf(*entry.step.filter, parameter) != size || (mayBeNone(size) && !entry.step.enabled)) continue;
      setSizeOf(agent, size, entry.step.values[parameter]);
      break;
    }
  }
  return agent;
}

}  // namespace footfall::ui
