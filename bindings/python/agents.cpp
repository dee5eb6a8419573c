// Agents: who is to walk.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <string>

#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/agent.hpp"
#include "footfall/errors.hpp"
#include "texts.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

py::tuple numbersOf(const Agent& agent) {
  return py::make_tuple(agent.maxSlope, agent.height, agent.step, agent.gap, agent.radius, agent.drop,
                        agent.minimumArea);
}

Agent makeAgent(double slope, double height, double step, double gap, double radius, double drop, double minimumArea) {
  const Agent agent{slope, height, minimumArea, step, gap, radius, drop};
  checkAgent(agent);
  return agent;
}

std::string shown(const Agent& agent) {
  return py::str(
             "footfall.Agent(slope={!r}, height={!r}, step={!r}, gap={!r}, radius={!r}, drop={!r}, minimum_area={!r})")
      .format(*numbersOf(agent));
}

}  // namespace

Agent agentFrom(const py::object& agent, const Agent& numbers) {
  if (agent.is_none()) return numbers;
  if (!py::isinstance<Agent>(agent))
    throw InputError("agent: " + typeNameOf(agent) + " is not accepted; give a footfall.Agent");
  if (!(numbers == Agent()))
    throw InputError("agent: it has a slope, a height and so on of its own; give either an agent or such numbers");
  return agent.cast<Agent>();
}

void bindAgents(py::module_& module) {
  py::class_<Agent> agent(
      module, "Agent",
      R"(Who is to walk, in metres and degrees, for `walkable_area`, `run` and Environment.pipeline_for. It
never changes; two with the same numbers are equal.)");
  defineConstructor(agent, &makeAgent,
                    R"(slope: degrees, above 0 and below 90: the steepest ground that the agent walks on.
height: metres, above 0: the free height that it needs.
step: metres, at least 0: how high it climbs at once, on stairs and kerbs; 0: it does not lift its feet.
gap: metres, at least 0: how wide a gap it steps over, seen from above.
radius: metres, at least 0: how far its middle stays away from walls and ledges; 0: it is a point.
drop: metres, at least 0: how deep it drops from a ledge, one way; 0: it drops nowhere.
minimum_area: square metres, at least 0: connected parts that are no larger are left out.

Raises InputError for a number out of range.)",
                    py::arg("slope") = 45.0, py::arg("height") = 2.0, py::arg("step") = 0.4, py::arg("gap") = 0.05,
                    py::arg("radius") = 0.0, py::arg("drop") = 0.0, py::kw_only(), py::arg("minimum_area") = 1.0);
  agent.def_readonly("slope", &Agent::maxSlope, "Degrees: the steepest ground that it walks on.")
      .def_readonly("height", &Agent::height, "Metres: the free height that it needs.")
      .def_readonly("step", &Agent::step, "Metres: how high it climbs at once; 0: it does not lift its feet.")
      .def_readonly("gap", &Agent::gap, "Metres: how wide a gap it steps over, seen from above.")
      .def_readonly("radius", &Agent::radius,
                    "Metres: how far its middle stays away from walls and ledges; 0: it is a point.")
      .def_readonly("drop", &Agent::drop, "Metres: how deep it drops from a ledge, one way; 0: it drops nowhere.")
      .def_readonly("minimum_area", &Agent::minimumArea,
                    "Square metres: connected parts that are no larger are left out.")
      .def(
          "__eq__", [](const Agent& a, const Agent& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const Agent& a) { return py::hash(numbersOf(a)); })
      .def("__repr__", &shown)
      .def(py::pickle(&numbersOf, [](const py::tuple& numbers) {
        return makeAgent(numbers[0].cast<double>(), numbers[1].cast<double>(), numbers[2].cast<double>(),
                         numbers[3].cast<double>(), numbers[4].cast<double>(), numbers[5].cast<double>(),
                         numbers[6].cast<double>());
      }));

  define(
      module, "agents",
      [] {
        py::dict known;
        for (const KnownAgent& one : knownAgents()) known[py::str(std::string(one.name))] = one.agent;
        return known;
      },
      R"(Return known agents by name, a dict of `Agent`: people and things that walk or roll ("Human", "Wheelchair",
"Robot", ...) and the defaults of other navigation tools ("Unity", "Unreal", "Godot", "Recast").)");
}

}  // namespace footfall::python
