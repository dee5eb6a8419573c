// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/agents_run.hpp"

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/io/export.hpp"
#include "footfall/agent_list.hpp"
#include "footfall/errors.hpp"
#include "footfall/report.hpp"

namespace footfall::app {
using namespace detail;
namespace {

using Json = nlohmann::ordered_json;

std::string lineOf(const std::string& name, const AgentRun& run, const std::string& output) {
  const RunResult& result = run.result;
  return name + ": " + describeAgent(run.pipeline) + "; area " + formatted(result.summary.area, "%.6g") + ", " +
         counted(result.summary.triangles, "triangle", "triangles") + "; " + std::to_string(computedSteps(result)) +
         " of " + counted(result.steps.size(), "step", "steps") + " computed for it, " +
         formatted(result.totalMs, "%.1f ms") + (output.empty() ? "" : "; " + output) + '\n';
}

}  // namespace

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
  const std::vector<ListedAgent> listed = readAgents(run.agents, environment->metresPerUnit, &session.context());
  WriteTargets targets = targetsBeside(run.environment, {});
  targets.add(run.statistics, FOOTFALL_TEXT("the statistics"));
  std::set<std::string> outputs;
  std::vector<Agent> agents;
  for (const ListedAgent& each : listed) {
    agents.push_back(each.agent);
    if (!outputs.insert(agentOutput(run.exported.output, each.name)).second)
      throw InputError("--agents: two agents have the name '" + each.name + "'; give each a name of its own");
  }
  std::string summary;
  Json statistics;
  statistics["agents"] = Json::array();
  session.runAgents(environment, agents, [&](std::size_t agent, const AgentRun& each) {
    ExportCommandOptions exported = run.exported;
    ProgramTimes times;
    if (!exported.output.empty()) {
      exported.output = agentOutput(exported.output, listed[agent].name);
      const Stopwatch exporting;
      session.begin("exporting");
      const double error = writeExport(exported, *each.result.mesh, each.pipeline, targets, session.context());
      times.exportMs = exporting.wallMs();
      session.end();
      if (!run.quiet) printLosses(*each.result.mesh, exported, error);
    }
    session.end();
    summary += lineOf(listed[agent].name, each, exported.output);
    if (run.statistics.empty()) return;
    Json json;
    json["name"] = listed[agent].name;
    json["output"] = exported.output.empty() ? Json() : Json(exported.output);
    json["computed_steps"] = computedSteps(each.result);
    json["added_ms"] = each.result.totalMs;
    json["statistics"] = Json::parse(formatStatistics(*environment, each.result, times));
    statistics["agents"].push_back(std::move(json));
  });
  if (!run.statistics.empty())
    writeFileSafely(run.statistics, statistics.dump(2, ' ', false, Json::error_handler_t::replace) + '\n',
                    session.context());
  return run.quiet ? std::string() : summary;
}

}  // namespace footfall::app
