// The types that the parts of the module share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

#include "footfall/agent.hpp"
#include "footfall/environment.hpp"
#include "footfall/inspect.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "footfall/run_context.hpp"

namespace footfall::python {

namespace py = pybind11;

/// The pointer that Python holds of something that never changes: its classes have no method that would change it.
template <class Type>
std::shared_ptr<Type> held(std::shared_ptr<const Type> shared) {
  return std::const_pointer_cast<Type>(std::move(shared));
}

/// A navigation mesh, and the data made of it on first use. Only touched with the interpreter lock held.
struct Mesh {
  std::shared_ptr<const NavigationMesh> data;
  std::shared_ptr<const PathFinder> finder = nullptr;
  std::string label = "mesh of arrays";  ///< in reports
  std::string agent = {};                ///< the agent that an area is for, in words; tells areas of one label apart
};

/// The result of a run: its mesh, and what it was made from.
struct Area : Mesh {
  std::shared_ptr<const Environment> environment;
  Pipeline pipeline;
  RunResult result;
  std::shared_ptr<ResultCache> cache;
  std::shared_ptr<const SeparationFinder> separations = nullptr;
  std::shared_ptr<const Inspector> inspector = nullptr;
  /// The texts of formatStatistics() and formatSummary() for the run. They are set for an area from a pickle, whose
  /// `result` has its mesh, its area and the number of threads only.
  std::optional<std::string> statistics = std::nullopt, summary = std::nullopt;
};

/// The path finder of a mesh, made once.
std::shared_ptr<const PathFinder> finderOf(Mesh& mesh);

/// The height above or below a place within which its ground may lie: the given one, or `otherwise`. Throws InputError.
double reachFrom(std::optional<double> reach, double otherwise);

/// The numbers of a mesh for people: "4 vertices, 2 triangles, 1 layer".
std::string sizesOf(const NavigationMesh& mesh);

/// The words for an area in reports.
std::string labelOf(const Environment& environment);

/// A pipeline from its text, or from a sequence of steps: "SlopeFilter 45" or ("SlopeFilter", 45). Throws InputError.
Pipeline pipelineFrom(const py::object& given);

/// The agent that is given, a footfall.Agent; for None one of `numbers`, which must be the defaults otherwise. Throws
/// InputError.
Agent agentFrom(const py::object& agent, const Agent& numbers);

/// The up axis of a name such as "z" or "-y"; nothing for None. Throws InputError for anything else.
std::optional<UpAxis> upAxisFrom(const std::optional<std::string>& name);

/// Runs a pipeline; interruptible.
std::shared_ptr<Area> run(std::shared_ptr<const Environment> environment, Pipeline pipeline, int threads,
                          std::shared_ptr<ResultCache> cache, const py::object& progress);

/// The options for taking arrays.
struct ArraysOptions {
  std::string up = "z";
  double metresPerUnit = 1;
  bool bothSides = false;
  py::object obstacleOnly = py::none();
  std::string name = "arrays";
};

/// An environment of arrays, in order for a run. Throws InputError.
std::shared_ptr<const Environment> environmentFrom(const py::object& vertices, const py::object& triangles,
                                                   const ArraysOptions& options);

}  // namespace footfall::python
