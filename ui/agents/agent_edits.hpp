// Edits of a document's agents. Each is one entry of the undo history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/agent_rules.hpp"

namespace footfall::ui {

/// Adds an agent with a free name and id, and makes it the active one. Returns the id.
int addAgent(Document& document, const NamedAgent& agent);
/// Inserts a copy behind the original. Returns the id; 0 where there is no such agent.
int duplicateAgent(Document& document, int id);
/// Removes an agent; the filters do not change, even if it was active.
void removeAgent(Document& document, int id);
/// An empty name changes nothing.
void renameAgent(Document& document, int id, const QString& name);
/// `value` must be valid (parameterOf()). The filters change with the active agent.
void resizeAgent(Document& document, int id, AgentSize size, double value);
/// Sets the filters to the agent's sizes; 0: no agent is active. Several switches in a row are one entry.
void activateAgent(Document& document, int id);
/// Makes an agent with the values of the first filters that have them, else those of a human. It has no steps where no
/// filter for them is on.
NamedAgent agentOfFilters(const DocumentState& state, double metresPerUnit);

}  // namespace footfall::ui
