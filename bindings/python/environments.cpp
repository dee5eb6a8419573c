// Environments: from files, from arrays, and with obstacles that are edited.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/agent.hpp"
#include "footfall/edit.hpp"
#include "footfall/environment.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "footfall/up_axis.hpp"
#include "interruptible.hpp"
#include "pickling.hpp"
#include "texts.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

using SharedEnvironment = std::shared_ptr<const Environment>;

/// "auto", "on", "off" or a step.
void setGrid(const std::variant<double, std::string>& grid, ImportOptions& options) {
  if (const double* step = std::get_if<double>(&grid)) {
    options.grid = GridChoice::Step;
    options.gridStep = *step;
    return;
  }
  const std::string& name = std::get<std::string>(grid);
  if (name == "on")
    options.grid = GridChoice::On;
  else if (name == "off")
    options.grid = GridChoice::Off;
  else if (name != "auto")
    throw InputError("grid: '" + name + "' is no choice; give 'auto', 'on', 'off' or a step");
}

SharedEnvironment loadFile(const std::filesystem::path& path, const std::optional<std::string>& up,
                           std::optional<double> metresPerUnit, bool bothSides,
                           const std::variant<double, std::string>& grid, bool limits) {
  ImportOptions options{upAxisFrom(up), metresPerUnit, bothSides};
  setGrid(grid, options);
  options.limitReaders = limits;
  return interruptible(py::none(), [&](RunContext& context) {
    return std::make_shared<const Environment>(load(path.string(), options, &context));
  });
}

/// The mesh and the material of each part.
py::list partsOf(const Environment& environment) {
  py::list parts;
  for (const EnvironmentPart& part : environment.parts)
    parts.append(py::make_tuple(shownText(part.mesh), shownText(part.material)));
  return parts;
}

std::shared_ptr<Environment> withRoles(const SharedEnvironment& level, const py::object& obstacleOnly,
                                       const py::object& ignored) {
  const std::size_t count = level->triangles.size();
  std::vector<std::uint8_t> isObstacle = level->obstacleOnly, isIgnored(count, 0);
  if (!obstacleOnly.is_none()) isObstacle = flagsFrom(obstacleOnly, "obstacle_only", count);
  if (!ignored.is_none()) isIgnored = flagsFrom(ignored, "ignored", count);
  std::vector<std::uint32_t> removed;
  for (std::size_t t = 0; t < count; ++t)
    if (isIgnored[t] != 0) removed.push_back(static_cast<std::uint32_t>(t));
  if (removed.size() == count) throw InputError("ignored: no triangle is left; ignore fewer");
  auto changed = editedCopy(level, removed);
  changed->obstacleOnly.clear();
  if (!isObstacle.empty())
    for (const std::uint32_t t : changed->edit->keptTriangles) changed->obstacleOnly.push_back(isObstacle[t]);
  return changed;
}

py::str shown(const Environment& environment) {
  return shownText("<footfall.Environment " + environment.source + ": " + std::to_string(environment.vertices.size()) +
                   " vertices, " + std::to_string(environment.triangles.size()) + " triangles>");
}

}  // namespace

std::optional<UpAxis> upAxisFrom(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  const std::optional<UpAxis> up = footfall::upAxisFrom(*name);
  if (!up) throw InputError("up: \"" + *name + "\" is no axis; give \"z\", \"y\", \"x\", \"-z\", \"-y\" or \"-x\"");
  return up;
}

SharedEnvironment environmentFrom(const py::object& vertices, const py::object& triangles,
                                  const ArraysOptions& options) {
  auto environment = std::make_shared<Environment>();
  environment->source = options.name;
  environment->vertices = pointsFrom(vertices, "vertices");
  environment->triangles = trianglesFrom(triangles, "triangles", environment->vertices.size());
  if (!options.obstacleOnly.is_none())
    environment->obstacleOnly = flagsFrom(options.obstacleOnly, "obstacle_only", environment->triangles.size());
  environment->up = *upAxisFrom(options.up);
  environment->upGuessed = false;
  environment->metresPerUnit = options.metresPerUnit;
  environment->scaleGuessed = false;
  environment->bothSides = options.bothSides;
  for (Vec3& vertex : environment->vertices) vertex = fromFileFrame(vertex, environment->up);
  checkEnvironment(*environment);
  return environment;
}

void bindEnvironments(py::module_& module) {
  py::class_<Environment, std::shared_ptr<Environment>> environment(
      module, "Environment",
      R"(A triangle soup: what the agent walks on and bumps into. It never changes.

Inside, Z is up, whatever the file has, and coordinates are the file's own doubles in the file's units.
Arrays are views without a copy that cannot be written to, and keep what they show alive.)");
  defineConstructor(
      environment,
      [](const py::object& vertices, const py::object& triangles, const std::string& up, double metresPerUnit,
         bool bothSides, const py::object& obstacleOnly, const py::str& name) {
        return held(environmentFrom(vertices, triangles,
                                    {up, metresPerUnit, bothSides, obstacleOnly, bytesOfName(name, "name")}));
      },
      R"(Make an environment from arrays, which are copied.

vertices: shape (n, 3), float64: x, y and z, finite.
triangles: shape (m, 3), integers: the numbers of three vertices, counter-clockwise seen from the front; only
    front sides can be walked on. They need not be connected, and may cross each other.
up: the axis that points up in `vertices`: "z", "y", "x", "-z", "-y" or "-x". `Environment.vertices` is
    turned to Z up, and files that are saved are turned back.
metres_per_unit: for heights and areas that are given in metres; coordinates stay as they are.
both_sides: take both sides of each triangle as its front, for soups with unreliable winding.
obstacle_only: shape (m,), bool: triangles that are never walkable, but obstacles.
name: for messages and in the comments of files that are saved.

Raises InputError for arrays of another shape or type, without rows, with NaN or infinite coordinates, or with
numbers of vertices that do not exist.)",
      py::arg("vertices"), py::arg("triangles"), py::kw_only(), py::arg("up") = "z", py::arg("metres_per_unit") = 1.0,
      py::arg("both_sides") = false, py::arg("obstacle_only") = py::none(), py::arg("name") = "arrays");
  environment
      .def_property_readonly(
          "vertices", [](const std::shared_ptr<Environment>& e) { return viewOf(e->vertices, baseOf<Environment>(e)); },
          "Shape (n, 3), float64, Z up, the file's units. A view.")
      .def_property_readonly(
          "triangles",
          [](const std::shared_ptr<Environment>& e) { return viewOf(e->triangles, baseOf<Environment>(e)); },
          "Shape (m, 3), uint32: rows of `vertices`. A view.")
      .def_property_readonly(
          "source", [](const Environment& e) { return fileNameOf(e.source); }, "The file, or the name given.")
      .def_property_readonly(
          "up", [](const Environment& e) { return nameOf(e.up); }, "The up axis of the file: \"z\", \"-y\", ...")
      .def_property_readonly(
          "up_is_guessed", [](const Environment& e) { return e.upGuessed; },
          "Whether neither the file nor the caller said which axis is up.")
      .def_property_readonly(
          "metres_per_unit", [](const Environment& e) { return e.metresPerUnit; },
          "Metres for each unit of the coordinates.")
      .def_property_readonly(
          "scale_is_guessed", [](const Environment& e) { return e.scaleGuessed; },
          "Whether neither the file nor the caller said what a unit is.")
      .def_property_readonly(
          "both_sides", [](const Environment& e) { return e.bothSides; },
          "Whether both sides of each triangle are its front.")
      .def_property_readonly(
          "grid_step", [](const Environment& e) { return e.grid.step; },
          "The step of the grid on which all coordinates lie, in units of the file; 0 where there is no grid.")
      .def_property_readonly("parts", &partsOf, "(mesh, material) names of the file's parts; empty where it has none.")
      .def_property_readonly(
          "part_of",
          [](const std::shared_ptr<Environment>& e) -> py::object {
            if (e->partOf.empty()) return py::none();
            return viewOf(e->partOf, baseOf<Environment>(e));
          },
          "Shape (m,), uint32: of each triangle its place in `parts`; None where there are no parts. A view.")
      .def_property_readonly(
          "obstacle_only",
          [](const std::shared_ptr<Environment>& e) -> py::object {
            if (e->obstacleOnly.empty()) return py::none();
            return viewOf(e->obstacleOnly, baseOf<Environment>(e));
          },
          "Shape (m,), bool: triangles that are never walkable; None where there are none. A view.")
      .def_property_readonly(
          "skipped_polygons", [](const Environment& e) { return e.skipped.polygons; },
          "How many polygons of the file were left out, having fewer than three distinct corners.")
      .def("__repr__", &shown)
      .def(py::pickle([](const Environment& e) { return stateOf(e); }, &environmentFromState));
  defineCopies(environment);
  define(
      environment, "pipeline_for",
      [](const Environment& level, double slope, double height, double minimumArea, double step, double gap,
         double radius, double drop, const py::object& agent) {
        return pipelineFor(level, agentFrom(agent, {slope, height, minimumArea, step, gap, radius, drop}));
      },
      R"(Return the `Pipeline` that computes where an agent can walk, in the units of this environment.

slope: degrees, above 0 and below 90: the steepest ground that the agent walks on.
height: metres, above 0: the free height that it needs.
minimum_area: square metres: connected parts that are no larger are left out.
step: metres, at least 0: how high it climbs at once, on stairs and kerbs; 0: it does not lift its feet.
gap: metres, at least 0: how wide a gap it steps over, seen from above.
radius: metres, at least 0: how far its middle stays away from walls and ledges; 0: it is a point.
drop: metres, at least 0: how deep it drops from a ledge, one way; 0: it drops nowhere.
agent: an `Agent` in place of all these numbers, or None.

Raises InputError for a number out of range.)",
      py::arg("slope") = 45.0, py::arg("height") = 2.0, py::kw_only(), py::arg("minimum_area") = 1.0,
      py::arg("step") = 0.4, py::arg("gap") = 0.05, py::arg("radius") = 0.0, py::arg("drop") = 0.0,
      py::arg("agent") = py::none());

  define(
      environment, "with_roles",
      [](const std::shared_ptr<Environment>& level, const py::object& obstacleOnly, const py::object& ignored) {
        return withRoles(level, obstacleOnly, ignored);
      },
      R"(Return this environment with other roles for some of its triangles: a new `Environment`.

obstacle_only: shape (m,), bool: triangles that are never walkable, but obstacles; None: those that are so already.
ignored: shape (m,), bool: triangles that are not there any more; None: none.

Parts of a file are found by `part_of`, as in level.with_roles(ignored=level.part_of == 3).)",
      py::kw_only(), py::arg("obstacle_only") = py::none(), py::arg("ignored") = py::none());

  define(
      module, "load",
      [](const std::filesystem::path& path, const std::optional<std::string>& up, std::optional<double> metresPerUnit,
         bool bothSides, const std::variant<double, std::string>& grid,
         bool limits) { return held(loadFile(path, up, metresPerUnit, bothSides, grid, limits)); },
      R"(Read an environment from a file (OBJ at double precision; glTF, PLY, STL, COLLADA, IFC and what else Assimp
reads: `importable_extensions()`) and return an `Environment`.

up: the file's up axis ("z", "y", "x", "-z", "-y", "-x"); None: as the format has it.
metres_per_unit: None: as the format has it.
both_sides: take both sides of each triangle as its front.
grid: round coordinates to a grid: "auto" (files of floats, such as glTF), "on", "off", or a step in units of the file.
limits: end reading a foreign format where it takes far more time or memory than files of that size need.

Raises InputError, also for a file that is missing.)",
      py::arg("path"), py::kw_only(), py::arg("up") = py::none(), py::arg("metres_per_unit") = py::none(),
      py::arg("both_sides") = false, py::arg("grid") = "auto", py::arg("limits") = true);
  define(module, "importable_extensions", &importableExtensions,
         "Return the file name extensions that `load` reads: a list of str, lower case, without the dot.");

  py::class_<EditableEnvironment> editable(module, "EditableEnvironment",
                                           R"(A level with obstacles that come, move and go.

Each change makes a new `environment`; run(level.environment, pipeline, cache=cache) with one `ResultCache` for
all runs then computes only what the change can affect. The result is that of a run from nothing.)");
  defineConstructor(
      editable,
      [](std::shared_ptr<Environment> level) { return std::make_unique<EditableEnvironment>(std::move(level)); },
      "Begin with an `Environment`.", py::arg("environment").none(false));
  editable.def_property_readonly(
      "environment", [](const EditableEnvironment& level) { return held(level.environment()); },
      "The `Environment` as it is now. One that was taken earlier stays as it was.");
  define(
      editable, "add",
      [](EditableEnvironment& level, const py::object& vertices, const py::object& triangles) {
        return level.add(soupFrom(vertices, triangles));
      },
      "Add an obstacle and return its number, an int. Arrays as for `Environment`, Z up. Raises InputError.",
      py::arg("vertices"), py::arg("triangles"));
  define(
      editable, "replace",
      [](EditableEnvironment& level, ObstacleId id, const py::object& vertices, const py::object& triangles) {
        level.replace(id, soupFrom(vertices, triangles));
      },
      "Put something else where obstacle `id` was: moved, turned, or another shape. Raises InputError.", py::arg("id"),
      py::arg("vertices"), py::arg("triangles"));
  define(
      editable, "remove", [](EditableEnvironment& level, ObstacleId id) { level.remove(id); },
      "Take obstacle `id` away. Raises InputError where there is none.", py::arg("id"));
}

}  // namespace footfall::python
