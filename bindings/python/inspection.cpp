// Connected parts, and why a place is walkable or not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/inspect.hpp"
#include "footfall/report.hpp"
#include "interruptible.hpp"
#include "pickling.hpp"
#include "texts.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

/// An answer, and who gave it.
struct Explanation {
  std::shared_ptr<const Inspector> inspector;
  PlaceExplanation answer;
  std::optional<std::string> filter;  ///< the step that rejected the place
};

py::object heightAndTriangle(const std::optional<TriangleAbove>& above) {
  if (!above) return py::none();
  return py::make_tuple(above->height, above->triangle);
}

std::shared_ptr<const Inspector> inspectorOf(Area& area) {
  if (!area.inspector)
    area.inspector = interruptible(py::none(), [&](RunContext& context) {
      return std::make_shared<const Inspector>(area.environment, area.pipeline, area.data, area.cache.get(), &context,
                                               area.result.threads);
    });
  return area.inspector;
}

Explanation explain(const std::shared_ptr<Area>& area, const py::object& point, std::optional<std::uint32_t> triangle) {
  const Vec3 at = pointFrom(point, "point");
  const auto inspector = inspectorOf(*area);
  const std::optional<PickedPlace> place = triangle ? PickedPlace{*triangle, at} : inspector->placeBelow(at);
  if (!place) throw InputError("point: nothing is at or under it; give a point on a triangle or above one");
  PlaceExplanation answer =
      interruptible(py::none(), [&](RunContext& context) { return inspector->explain(*place, &context); });
  std::optional<std::string> filter;
  if (answer.step) filter = area->pipeline.steps[*answer.step].filter->name;
  return {inspector, std::move(answer), std::move(filter)};
}

void bindComponents(py::module_& module) {
  py::class_<Component>(module, "Component", "A part of a walkable area that hangs together: one of `Components`.")
      .def_property_readonly(
          "area", [](const Component& c) { return c.area; }, "Of the surface, in the square of the environment's unit.")
      .def_property_readonly(
          "triangles", [](const Component& c) { return c.triangles; }, "How many.")
      .def_property_readonly(
          "lower", [](const Component& c) { return arrayOf(c.lower); }, "Of its box: shape (3,).")
      .def_property_readonly(
          "upper", [](const Component& c) { return arrayOf(c.upper); }, "Of its box: shape (3,).")
      .def_property_readonly(
          "centre", [](const Component& c) { return arrayOf(c.centre); },
          "Of mass: shape (3,); it may lie beside the component.")
      .def_property_readonly(
          "layers", [](const Component& c) { return c.layers; }, "That it has a part in: a list of int.")
      .def("__repr__",
           [](const Component& c) {
             return "<footfall.Component: area " + std::string(py::str(py::float_(c.area))) + ", " +
                    std::to_string(c.triangles) + " triangles>";
           })
      .def(py::pickle([](const Component& c) { return stateOf(c); }, &componentFromState));
}

void bindExplanation(py::module_& module) {
  py::class_<Explanation>(
      module, "Explanation",
      "Why a place is walkable, or why not: the answer of `WalkableArea.why`. str(explanation) is for people.")
      .def_property_readonly(
          "is_walkable", [](const Explanation& e) { return e.answer.verdict == PlaceVerdict::Walkable; },
          "Whether the verdict is \"walkable\".")
      .def_property_readonly(
          "verdict", [](const Explanation& e) { return verdictWord(e.inspector->pipeline(), e.answer); },
          R"("walkable", or what it is instead: "no_area" (the triangle is degenerate), "vertical", "faces_down",
"obstacle_only", "too_steep", "too_low" (under something), "region_too_small", "unreachable" (from the seeds),
"too_near_wall", "too_near_ledge", "moved" (a filter that moves vertices left nothing here), or the word of another filter.)")
      .def_property_readonly(
          "filter", [](const Explanation& e) { return e.filter; },
          "The name of the filter that rejected it; None where none did.")
      .def_property_readonly(
          "step", [](const Explanation& e) { return e.answer.step; },
          "Its number in the pipeline, from 0; None where none did.")
      .def_property_readonly(
          "limit", [](const Explanation& e) { return e.answer.limit; },
          "Of that filter: degrees, a height, an area or a distance, as its parameter.")
      .def_property_readonly(
          "point", [](const Explanation& e) { return arrayOf(e.answer.place.point); },
          "Shape (3,): the place, on its triangle.")
      .def_property_readonly(
          "triangle", [](const Explanation& e) { return e.answer.place.triangle; }, "A row of `Environment.triangles`.")
      .def_property_readonly(
          "slope", [](const Explanation& e) { return e.answer.slope; },
          "Of the triangle, degrees from 0 (faces up) to 180.")
      .def_property_readonly(
          "above", [](const Explanation& e) { return heightAndTriangle(e.answer.above); },
          "(height above the place, triangle) of the lowest thing above it; None: nothing is.")
      .def_property_readonly(
          "obstacle", [](const Explanation& e) { return heightAndTriangle(e.answer.obstacle); },
          "Where it is \"too_low\": (height above the place, triangle) of what is within the height.")
      .def_property_readonly(
          "wall_distance", [](const Explanation& e) { return e.answer.wallDistance; },
          "How far the nearest wall is, straight over the walkable area (before a RadiusFilter), in the plan; None "
          "where "
          "there is none.")
      .def_property_readonly(
          "ledge_distance", [](const Explanation& e) { return e.answer.ledgeDistance; },
          "The same of the nearest ledge: a drop, or an end of the world.")
      .def_property_readonly(
          "walls", [](const Explanation& e) { return e.answer.walls; },
          "Vertical triangles that stand exactly here: a list of int.")
      .def_property_readonly(
          "floor", [](const Explanation& e) { return e.answer.floor; },
          "Another triangle in the same plane that is the floor here; None where there is none.")
      .def_property_readonly(
          "region_area", [](const Explanation& e) { return e.answer.regionArea; },
          "Where it is \"region_too_small\": the area of what was removed.")
      .def_property_readonly(
          "layer", [](const Explanation& e) { return e.answer.layer; },
          "Where it is walkable: its layer; None without layers.")
      .def_property_readonly(
          "component",
          [](const Explanation& e) -> std::optional<std::uint32_t> {
            if (e.answer.verdict != PlaceVerdict::Walkable) return std::nullopt;
            return e.answer.component;
          },
          "Where it is walkable: its place in `NavigationMesh.components()`; None elsewhere.")
      .def("__str__", [](const Explanation& e) { return shownText(formatExplanation(*e.inspector, e.answer)); })
      .def("__repr__", [](const Explanation& e) {
        return "<footfall.Explanation " + std::string(verdictWord(e.inspector->pipeline(), e.answer)) +
               (e.filter ? " (" + *e.filter + ")" : std::string()) + ">";
      });
}

}  // namespace

void bindInspection(py::module_& module) {
  bindComponents(module);
  bindExplanation(module);
  auto mesh = static_cast<py::class_<Mesh, std::shared_ptr<Mesh>>>(module.attr("NavigationMesh"));
  define(
      mesh, "components",
      [](const std::shared_ptr<Mesh>& m) {
        const auto found = interruptible(py::none(), [&data = m->data](RunContext& context) {
          return std::make_shared<const Components>(findComponents(*data, &context));
        });
        return py::module_::import("footfall")
            .attr("Components")(found->list, viewOf(found->ofTriangle, baseOf(found)));
      },
      "Return the connected parts, a list, `Components`: an agent gets from a triangle to all others of its part.");
  auto area = static_cast<py::class_<Area, Mesh, std::shared_ptr<Area>>>(module.attr("WalkableArea"));
  define(area, "why", &explain,
         R"(Return why a place is walkable or not: an `Explanation`, exactly, from what each step of the run did.

point: three numbers, Z up. What is meant is the highest place at or under it.
triangle: a row of `Environment.triangles`; the place is then on that triangle.

The first call runs the pipeline again where the run had no cache. Raises InputError where nothing is under
the point.)",
         py::arg("point"), py::kw_only(), py::arg("triangle") = py::none());
}

}  // namespace footfall::python
