// Runs for lists of agents.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "footfall/agent.hpp"
#include "footfall/errors.hpp"
#include "interruptible.hpp"
#include "runs.hpp"
#include "texts.hpp"

namespace footfall::python {
namespace {

std::vector<Agent> agentListFrom(const py::object& given) {
  std::vector<Agent> agents;
  for (const py::handle agent : given) {
    if (!py::isinstance<Agent>(agent))
      throw InputError("pipeline[" + std::to_string(agents.size()) + "]: " + typeNameOf(agent) +
                       " is not accepted among agents; give a footfall.Agent");
    agents.push_back(agent.cast<Agent>());
  }
  return agents;
}

}  // namespace

bool isAgentList(const py::object& pipeline) {
  if (!py::isinstance<py::list>(pipeline) && !py::isinstance<py::tuple>(pipeline)) return false;
  const auto list = py::reinterpret_borrow<py::sequence>(pipeline);
  if (list.empty())
    throw InputError(
        "pipeline: the list is empty; give a step or an agent in it, or footfall.Pipeline([]) to run no step");
  return py::isinstance<Agent>(list[0]);
}

py::list runAgentList(const std::shared_ptr<const Environment>& environment, const py::object& agents, int threads,
                      const std::shared_ptr<ResultCache>& cache, const py::object& progress) {
  const std::vector<Agent> list = agentListFrom(agents);
  checkThreads(threads);
  std::vector<AgentRun> runs = interruptible(
      progress, [&](RunContext& context) { return runAgents(environment, list, context, cache.get(), threads); });
  py::list areas;
  for (AgentRun& run : runs) areas.append(areaOf(environment, std::move(run), cache));
  return areas;
}

}  // namespace footfall::python
