// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/agents_run.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/io/export.hpp"
#include "core/io/input_file.hpp"
#include "footfall/agent.hpp"
#include "footfall/errors.hpp"
#include "footfall/report.hpp"

namespace footfall::app {
using namespace detail;
namespace {

using Json = nlohmann::ordered_json;

bool isSameName(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string namesOfKnownAgents() {
  std::string names;
  for (const KnownAgent& known : knownAgents()) names.append(names.empty() ? "" : ", ").append(known.name);
  return names;
}

AgentToRun knownAgentFor(std::string_view name, const Environment& environment) {
  for (const KnownAgent& known : knownAgents())
    if (isSameName(known.name, name)) return {std::string(known.name), pipelineFor(environment, known.agent)};
  throw InputError("--agents: there is no agent '" + std::string(name) + "'; give a file, or some of " +
                   namesOfKnownAgents());
}

AgentToRun agentFrom(const Json& json, const Environment& environment, const std::string& file) {
  const double metres = environment.metresPerUnit;
  const auto wrong = [&](const std::string& what) { return InputError(file + ": agents: " + what); };
  if (!json.is_object() || !json.contains("name") || !json["name"].is_string())
    throw wrong("each agent must be an object with a name");
  const auto name = json["name"].get<std::string>();
  const auto number = [&](const char* key, double scale, double& value) {
    if (!json.contains(key)) return;
    if (!json[key].is_number()) throw wrong("'" + name + "': " + key + " must be a number");
    value = json[key].get<double>() * scale;
  };
  Agent agent;
  number("max_slope", 1, agent.maxSlope);
  number("height", metres, agent.height);
  number("step", metres, agent.step);
  number("gap", metres, agent.gap);
  number("radius", metres, agent.radius);
  number("drop", metres, agent.drop);
  number("minimum_area", metres * metres, agent.minimumArea);
  try {
    return {name, pipelineFor(environment, agent)};
  } catch (const InputError& error) {
    throw wrong("'" + name + "': " + error.what());
  }
}

std::vector<AgentToRun> agentsOfFile(const std::string& file, const Environment& environment) {
  const Json json = Json::parse(readInputFile(file, nullptr), nullptr, false);
  const Json* const list = json.is_object() && json.contains("agents") ? &json["agents"] : &json;
  if (!list->is_array() || list->empty())
    throw InputError(file + ": holds no agents; give a JSON list of agents, or a session of the editor that has some");
  std::vector<AgentToRun> agents;
  for (const Json& agent : *list) agents.push_back(agentFrom(agent, environment, file));
  return agents;
}

std::size_t computedSteps(const RunResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.steps.begin(), result.steps.end(), [](const StepStatistics& s) { return !s.fromCache; }));
}

std::string lineOf(const AgentToRun& agent, const RunResult& result, const std::string& output) {
  return agent.name + ": " + describeAgent(agent.pipeline) + "; area " + formatted(result.summary.area, "%.6g") + ", " +
         counted(result.summary.triangles, "triangle", "triangles") + "; " + std::to_string(computedSteps(result)) +
         " of " + counted(result.steps.size(), "step", "steps") + " computed for it, " +
         formatted(result.totalMs, "%.1f ms") + (output.empty() ? "" : "; " + output) + '\n';
}

}  // namespace

std::vector<AgentToRun> agentsFor(const std::string& agents, const Environment& environment) {
  std::error_code error;
  if (std::filesystem::is_regular_file(agents, error)) return agentsOfFile(agents, environment);
  std::vector<AgentToRun> found;
  for (std::size_t begin = 0; begin <= agents.size();) {
    const std::size_t end = std::min(agents.find(',', begin), agents.size());
    found.push_back(knownAgentFor(std::string_view(agents).substr(begin, end - begin), environment));
    begin = end + 1;
  }
  return found;
}

std::string agentOutput(const std::string& output, const std::string& name) {
  std::string part = "-";
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || byte >= 0x80)
      part += static_cast<char>(std::tolower(byte));
    else if (part.back() != '-')
      part += '-';
  }
  const std::filesystem::path path(output);
  return (path.parent_path() / (path.stem().string() + part + path.extension().string())).string();
}

std::string runAgents(const AgentsRun& run, CommandSession& session) {
  run.exported.check();
  const std::shared_ptr<const Environment> environment = session.load(run.environment);
  const std::vector<AgentToRun> agents = agentsFor(run.agents, *environment);
  WriteTargets targets = targetsBeside(run.environment, {});
  targets.add(run.statistics, FOOTFALL_TEXT("the statistics"));
  std::set<std::string> outputs;
  for (const AgentToRun& agent : agents)
    if (!outputs.insert(agentOutput(run.exported.output, agent.name)).second)
      throw InputError("--agents: two agents have the name '" + agent.name + "'; give each a name of its own");
  ResultCache cache;
  std::string summary;
  Json statistics;
  statistics["agents"] = Json::array();
  for (const AgentToRun& agent : agents) {
    const RunResult result = session.run(environment, agent.pipeline, {}, &cache);
    ExportCommandOptions exported = run.exported;
    ProgramTimes times;
    if (!exported.output.empty()) {
      exported.output = agentOutput(exported.output, agent.name);
      const Stopwatch exporting;
      session.begin("exporting");
      const double error = writeExport(exported, *result.mesh, agent.pipeline, targets, session.context());
      times.exportMs = exporting.wallMs();
      session.end();
      if (!run.quiet) printLosses(*result.mesh, exported, error);
    }
    session.end();
    summary += lineOf(agent, result, exported.output);
    if (run.statistics.empty()) continue;
    Json json;
    json["name"] = agent.name;
    json["output"] = exported.output.empty() ? Json() : Json(exported.output);
    json["computed_steps"] = computedSteps(result);
    json["added_ms"] = result.totalMs;
    json["statistics"] = Json::parse(formatStatistics(*environment, result, times));
    statistics["agents"].push_back(std::move(json));
  }
  if (!run.statistics.empty())
    writeFileSafely(run.statistics, statistics.dump(2, ' ', false, Json::error_handler_t::replace) + '\n',
                    session.context());
  return run.quiet ? std::string() : summary;
}

}  // namespace footfall::app
