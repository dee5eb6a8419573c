// Runs one environment for several agents: what they have in common is computed once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/command_options.hpp"
#include "app/command_session.hpp"
#include "app/export_options.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::app {

/// An agent by its name, and its pipeline for an environment.
struct AgentToRun {
  std::string name;
  Pipeline pipeline;
};

/// The agents that `--agents` means: names of known agents, separated by commas, or a JSON file: a list of agents or an
/// object with a list `agents`, as the editor's sessions have it. An agent of a file has a `name`, and `height`,
/// `max_slope`, `step`, `gap`, `radius`, `drop` in the environment's units and `minimum_area` in their square; what it
/// leaves out is as in Agent. Throws InputError.
std::vector<AgentToRun> agentsFor(const std::string& agents, const Environment& environment);

/// The file of an agent beside `output`: "level.obj" becomes "level-wheelchair.obj".
std::string agentOutput(const std::string& output, const std::string& name);

struct AgentsRun {
  EnvironmentOptions environment;
  std::string agents;
  ExportCommandOptions exported;
  std::string statistics;  ///< empty: none
  bool quiet = false;
};

/// Runs all agents, in their order, and writes a result for each. Returns the summary for stdout, empty when quiet.
std::string runAgents(const AgentsRun& run, CommandSession& session);

}  // namespace footfall::app
