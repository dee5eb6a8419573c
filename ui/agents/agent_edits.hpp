// Edits of a document's agents, each one entry of the undo history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/agent_rules.hpp"

namespace footfall::ui {

/// Takes a free name and id, and becomes the active one. Returns the id.
int addAgent(Document& document, const NamedAgent& agent);
/// Behind the one that is copied. Returns the id; 0 where there is no such agent.
int duplicateAgent(Document& document, int id);
/// Removes an agent; the filters stay as they are, also those of the active one.
void removeAgent(Document& document, int id);
/// An empty name changes nothing.
void renameAgent(Document& document, int id, const QString& name);
/// `value` must be valid (parameterOf()). The active agent's filters follow.
void resizeAgent(Document& document, int id, AgentSize size, double value);
/// Sets the filters to the agent's sizes; 0: none is active any more. Switching several times in a row is one entry.
void activateAgent(Document& document, int id);
/// With the values of the first filters that take them, else of a human; no steps where no filter for them is on.
NamedAgent agentOfFilters(const DocumentState& state, double metresPerUnit);

}  // namespace footfall::ui
