// Paths for an agent with a body, for any radius.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "body_paths.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "arrays.hpp"
#include "definitions.hpp"
#include "footfall/body_path.hpp"
#include "footfall/path.hpp"
#include "interruptible.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

/// A finder, and the reach that is meant where none is given.
struct BodyPaths {
  std::shared_ptr<const BodyPathFinder> finder;
  double reach = std::numeric_limits<double>::infinity();
};

std::shared_ptr<BodyPaths> bodyPathsOf(const Mesh& mesh, double reach) {
  return interruptible(py::none(), [&data = mesh.data, reach](RunContext& context) {
    return std::make_shared<BodyPaths>(BodyPaths{std::make_shared<const BodyPathFinder>(data, &context), reach});
  });
}

std::shared_ptr<BodyPath> findBodyPath(const std::shared_ptr<BodyPaths>& paths, const py::object& start,
                                       const py::object& target, double radius, double preferredWidth,
                                       std::optional<double> reach) {
  const Vec3 from = pointFrom(start, "start"), to = pointFrom(target, "target");
  const double within = reachFrom(reach, paths->reach);
  return interruptible(py::none(), [&](RunContext& context) {
    return std::make_shared<BodyPath>(paths->finder->find(from, to, {radius, preferredWidth}, within, &context));
  });
}

void bindPassage(py::module_& module) {
  py::class_<Passage>(module, "Passage", "A narrow place of a walkable area. Lengths are in the plan.")
      .def_property_readonly(
          "place", [](const Passage& p) { return arrayOf(p.place); }, "Shape (3,), float64.")
      .def_property_readonly(
          "left", [](const Passage& p) { return arrayOf(p.left); }, "Shape (3,): the nearest place of the border.")
      .def_property_readonly(
          "right", [](const Passage& p) { return arrayOf(p.right); }, "The same on the other side.")
      .def_property_readonly(
          "width", [](const Passage& p) { return p.width; }, "Twice the distance to both.")
      .def("__repr__", [](const Passage& p) {
        return "<footfall.Passage: width " + std::string(py::str(py::float_(p.width))) + ">";
      });
}

void bindBodyPath(py::module_& module) {
  py::class_<BodyPath, std::shared_ptr<BodyPath>>(
      module, "BodyPath", "A path for an agent with a radius, or why there is none; str(path) is for people.")
      .def_property_readonly(
          "status", [](const BodyPath& p) { return statusWord(p); },
          R"("found", "start_too_near", "target_too_near" (to the border), "too_narrow" (every way is), or why
not even a point gets there, as in `Path.status`.)")
      .def_property_readonly("reached", &BodyPath::reached, "Whether the status is \"found\".")
      .def_property_readonly(
          "message", [](const BodyPath& p) { return formatFailure(p, UpAxis::Z); },
          "Why the target is not reached, in one line; empty where it is.")
      .def_property_readonly(
          "path", [](const BodyPath& p) { return std::make_shared<PathResult>(p.path); },
          "The `Path`. Its bends are corners of polygons around arcs.")
      .def_property_readonly(
          "narrowest", [](const BodyPath& p) { return p.narrowest; },
          R"(The narrowest `Passage` of the way; where the status is "too_narrow", the one that stops the agent, on the way
whose narrowest passage is widest.)")
      .def_property_readonly(
          "lacking", [](const BodyPath& p) { return p.lacking; },
          "The length that is missing: of the width of that passage, or of the distance of the start or the target.")
      .def_property_readonly(
          "start_distance", [](const BodyPath& p) { return p.startDistance; }, "From the start to the border.")
      .def_property_readonly(
          "target_distance", [](const BodyPath& p) { return p.targetDistance; }, "From the target to the border.")
      .def_property_readonly(
          "admissible",
          [](const BodyPath& p) -> py::object {
            if (!p.admissible) return py::none();
            return arrayOf(*p.admissible);
          },
          R"(Shape (3,): where the start or the target is too near to the border, a place that is far enough; None
elsewhere.)")
      .def("__str__",
           [](const BodyPath& p) {
             const std::string failure = formatFailure(p, UpAxis::Z);
             return (failure.empty() ? failure : failure + "\n") + formatPath(p, UpAxis::Z);
           })
      .def("__repr__", [](const BodyPath& p) {
        return "<footfall.BodyPath " + std::string(statusWord(p)) + ": length " +
               std::string(py::str(py::float_(p.path.length))) + ">";
      });
}

}  // namespace

void bindBodyPaths(py::module_& module) {
  bindPassage(module);
  bindBodyPath(module);
  py::class_<BodyPaths, std::shared_ptr<BodyPaths>> finder(
      module, "BodyPaths", "Finds paths for agents of any radius, by `NavigationMesh.body_paths`.");
  define(finder, "find", &findBodyPath,
         R"(Return the shortest `BodyPath` that keeps `radius` from every border.

start, target: three numbers, Z up, as in `NavigationMesh.find_path`. radius: above 0.
prefer_width: passages narrower than this are taken only where the way needs them; math.inf takes the widest way.
reach: as in `find_path`. Drops are not taken.

Raises InputError for numbers that are none.)",
         py::arg("start"), py::arg("target"), py::arg("radius"), py::kw_only(), py::arg("prefer_width") = 0.0,
         py::arg("reach") = py::none());
  auto mesh = static_cast<py::class_<Mesh, std::shared_ptr<Mesh>>>(module.attr("NavigationMesh"));
  define(
      mesh, "body_paths",
      [](const std::shared_ptr<Mesh>& m) { return bodyPathsOf(*m, std::numeric_limits<double>::infinity()); },
      R"(Return a `BodyPaths`, which finds paths for agents of any radius: this prepares the corridor map.

The mesh should be without the margins of a RadiusFilter.)");
  auto area = static_cast<py::class_<Area, Mesh, std::shared_ptr<Area>>>(module.attr("WalkableArea"));
  define(
      area, "body_paths", [](const std::shared_ptr<Area>& a) { return bodyPathsOf(*a, placeReach(a->pipeline)); },
      "As `NavigationMesh.body_paths`, with `reach` by default just less than the agent's height.");
}

}  // namespace footfall::python
