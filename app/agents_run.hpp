// Runs one environment for several agents: what they have in common is computed once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/command_options.hpp"
#include "app/command_session.hpp"
#include "app/export_options.hpp"

namespace footfall::app {

/// The file of an agent beside `output`: "level.obj" becomes "level-wheelchair.obj".
std::string agentOutput(const std::string& output, const std::string& name);

struct AgentsRun {
  EnvironmentOptions environment;
  std::string agents;  ///< as readAgents() takes it
  ExportCommandOptions exported;
  std::string statistics;  ///< empty: none
  bool quiet = false;
};

/// Runs all agents, in their order, and writes a result for each. Returns the summary for stdout, empty when quiet.
std::string runAgents(const AgentsRun& run, CommandSession& session);

}  // namespace footfall::app
