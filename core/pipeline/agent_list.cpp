// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/agent_list.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/io/input_file.hpp"
#include "core/pipeline/result_cache.hpp"
#include "footfall/errors.hpp"

namespace footfall {
using namespace detail;
namespace {

using Json = nlohmann::ordered_json;

bool isSameName(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

ListedAgent knownAgentNamed(std::string_view name) {
  std::string names;
  for (const KnownAgent& known : knownAgents()) {
    if (isSameName(known.name, name)) return {std::string(known.name), known.agent};
    names.append(names.empty() ? "" : ", ").append(known.name);
  }
  throw InputError("agents: there is no agent '" + std::string(name) + "'; give a file, or some of " + names);
}

ListedAgent agentFrom(const Json& json, double metres, const std::string& file) {
  const auto wrong = [&](const std::string& what) { return InputError(file + ": agents: " + what); };
  if (!json.is_object() || !json.contains("name") || !json["name"].is_string())
    throw wrong("each agent must be an object with a name");
  ListedAgent listed{json["name"].get<std::string>(), {}};
  const auto read = [&](const char* key, double scale, double& value) {
    if (!json.contains(key)) return;
    if (!json[key].is_number()) throw wrong("'" + listed.name + "': " + key + " must be a number");
    value = json[key].get<double>() * scale;
  };
  Agent& agent = listed.agent;
  read("max_slope", 1, agent.maxSlope);
  read("height", metres, agent.height);
  read("step", metres, agent.step);
  read("gap", metres, agent.gap);
  read("radius", metres, agent.radius);
  read("drop", metres, agent.drop);
  read("minimum_area", metres * metres, agent.minimumArea);
  try {
    checkAgent(agent);
  } catch (const InputError& error) {
    throw wrong("'" + listed.name + "': " + error.what());
  }
  return listed;
}

std::vector<Pipeline> pipelinesFor(const Environment& environment, std::span<const Agent> agents) {
  std::vector<Pipeline> pipelines;
  for (const Agent& agent : agents) {
    try {
      pipelines.push_back(pipelineFor(environment, agent));
    } catch (const InputError& error) {
      throw InputError("agents[" + std::to_string(pipelines.size()) + "]: " + error.what());
    }
  }
  return pipelines;
}

/// The keys of all prefixes of a pipeline, the shortest first.
std::vector<std::string> prefixKeys(const Pipeline& pipeline) {
  std::vector<const PipelineStep*> steps;
  for (const PipelineStep& step : pipeline.steps)
    if (step.enabled) steps.push_back(&step);
  std::vector<std::string> keys;
  for (std::size_t count = 0; count <= steps.size(); ++count) keys.push_back(prefixKey(steps, count));
  return keys;
}

/// The longest prefixes that two of the pipelines have in common.
std::unordered_set<std::string> sharedPrefixes(const std::vector<Pipeline>& pipelines) {
  std::vector<std::vector<std::string>> keys;
  for (const Pipeline& pipeline : pipelines) keys.push_back(prefixKeys(pipeline));
  std::unordered_set<std::string> shared;
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (std::size_t j = i + 1; j < keys.size(); ++j) {
      std::size_t count = 0;  // the prefixes of no step are equal
      while (count + 1 < std::min(keys[i].size(), keys[j].size()) && keys[i][count + 1] == keys[j][count + 1]) ++count;
      shared.insert(keys[i][count]);
    }
  return shared;
}

std::vector<ListedAgent> agentsNamed(std::string_view names) {
  std::vector<ListedAgent> found;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    found.push_back(knownAgentNamed(names.substr(begin, end - begin)));
    begin = end + 1;
  }
  return found;
}

}  // namespace

std::vector<ListedAgent> readAgents(const std::string& pathOrNames, double metresPerUnit, RunContext* context) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(pathOrNames, error)) return agentsNamed(pathOrNames);
  const Json json = Json::parse(readInputFile(pathOrNames, context), nullptr, false);
  const Json* const list = json.is_object() && json.contains("agents") ? &json["agents"] : &json;
  if (!list->is_array() || list->empty())
    throw InputError(pathOrNames +
                     ": holds no agents; give a JSON list of agents, or a session of the editor that has some");
  std::vector<ListedAgent> agents;
  for (const Json& agent : *list) agents.push_back(agentFrom(agent, metresPerUnit, pathOrNames));
  return agents;
}

std::size_t computedSteps(const RunResult& result) {
  return static_cast<std::size_t>(std::count_if(result.steps.begin(), result.steps.end(),
                                                [](const StepStatistics& step) { return !step.fromCache; }));
}

void runAgents(const std::shared_ptr<const Environment>& environment, std::span<const Agent> agents,
               RunContext& context, const AgentRunEvents& events, ResultCache* cache, int threads) {
  std::vector<Pipeline> pipelines = pipelinesFor(*environment, agents);
  std::optional<ResultCache> own;
  if (cache == nullptr) {
    std::unordered_set<std::string> shared = sharedPrefixes(pipelines);
    cache = &own.emplace(std::max<std::size_t>(shared.size(), 1));
    cache->inside().keepOnly(std::move(shared));
  }
  for (std::size_t i = 0; i < pipelines.size(); ++i) {
    if (events.started) events.started(i, pipelines[i]);
    AgentRun run{std::move(pipelines[i]), {}};
    run.result = runPipeline(environment, run.pipeline, context, cache, threads);
    if (events.finished) events.finished(i, std::move(run));
  }
}

std::vector<AgentRun> runAgents(const std::shared_ptr<const Environment>& environment, std::span<const Agent> agents,
                                RunContext& context, ResultCache* cache, int threads) {
  std::vector<AgentRun> runs;
  const AgentRunEvents events{{}, [&runs](std::size_t /*agent*/, AgentRun run) { runs.push_back(std::move(run)); }};
  runAgents(environment, agents, context, events, cache, threads);
  return runs;
}

}  // namespace footfall
