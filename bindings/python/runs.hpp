// Shared by the files about runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "footfall/agent_list.hpp"
#include "types.hpp"

namespace footfall::python {

/// Throws InputError for a number of threads that is out of range.
void checkThreads(int threads);

/// The area of a finished run.
std::shared_ptr<Area> areaOf(std::shared_ptr<const Environment> environment, AgentRun run,
                             std::shared_ptr<ResultCache> cache);

/// Returns whether a list or tuple begins with an agent. Throws InputError for an empty one, which may be a list of
/// agents or of steps.
bool isAgentList(const py::object& pipeline);

/// Runs the pipeline of each agent in a list and returns the list of areas; interruptible.
py::list runAgentList(const std::shared_ptr<const Environment>& environment, const py::object& agents, int threads,
                      const std::shared_ptr<ResultCache>& cache, const py::object& progress);

}  // namespace footfall::python
