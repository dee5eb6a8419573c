// Several agents in one environment: lists of agents, and runs that compute once what the agents have in common.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "footfall/agent.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

/// An agent of a list, by its name.
struct ListedAgent {
  std::string name;
  Agent agent;
  bool operator==(const ListedAgent&) const = default;
};

/// The agents of a list: names of known agents, which commas separate ("Human,wheelchair"; upper and lower case are the
/// same), or the path of a JSON file. The file holds a list of agents, or an object with a list `agents`, as the
/// editor's sessions have it. An agent of a file has a `name`. It may have `height`, `step`, `gap`, `radius` and `drop`
/// in units of `metresPerUnit` metres, `minimum_area` in their square, and `max_slope` in degrees; a number that is not
/// there is that of Agent. Throws InputError, also when a number is out of range.
std::vector<ListedAgent> readAgents(const std::string& pathOrNames, double metresPerUnit,
                                    RunContext* context = nullptr);

/// The run for one of several agents.
struct AgentRun {
  Pipeline pipeline;  ///< pipelineFor() the agent
  RunResult result;
};

/// The number of enabled steps that a run computed; it took the others from its cache.
std::size_t computedSteps(const RunResult& result);

/// Functions that runAgents() calls in the calling thread, with an agent's place in the list. Either may be empty.
struct AgentRunEvents {
  std::function<void(std::size_t agent, const Pipeline& pipeline)> started;
  std::function<void(std::size_t agent, AgentRun run)> finished;
};

/// Runs the pipeline of each agent over the environment, one after the other, in their order. A step that several
/// pipelines begin with runs once. Each result has the bytes of a run of its own; its `steps` say which of them the
/// agent added (computedSteps()), and its times are what the agent added. `cache` and `threads` are
/// those of runPipeline(); without a cache, only the states that several agents begin with are kept for this call.
/// Throws what runPipeline() throws, and InputError that names the agent's place in the list, before the first run,
/// when a number of an agent is out of range.
void runAgents(const std::shared_ptr<const Environment>& environment, std::span<const Agent> agents,
               RunContext& context, const AgentRunEvents& events, ResultCache* cache = nullptr, int threads = 0);
/// The same; returns the runs in the order of the agents.
std::vector<AgentRun> runAgents(const std::shared_ptr<const Environment>& environment, std::span<const Agent> agents,
                                RunContext& context, ResultCache* cache = nullptr, int threads = 0);

}  // namespace footfall
