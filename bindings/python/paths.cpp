// Paths, and what keeps two places apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/errors.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "interruptible.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

py::object placeOf(const std::optional<SurfacePlace>& place) {
  if (!place) return py::none();
  return arrayOf(place->position);
}

std::shared_ptr<const SeparationFinder> separationsOf(Area& area, const PathFinder& finder) {
  if (!area.separations)
    area.separations = interruptible(py::none(), [&](RunContext& context) {
      return std::make_shared<const SeparationFinder>(finder, area.environment,
                                                      agentHeight(area.pipeline, area.environment->metresPerUnit),
                                                      agentStep(area.pipeline), &context, agentGap(area.pipeline));
    });
  return area.separations;
}

std::shared_ptr<PathResult> findPath(const PathFinder& finder, const py::object& start, const py::object& target,
                                     double reach) {
  const Vec3 from = pointFrom(start, "start"), to = pointFrom(target, "target");
  return interruptible(py::none(), [&](RunContext& context) {
    return std::make_shared<PathResult>(finder.find(from, to, reach, &context));
  });
}

std::shared_ptr<PathResult> findOnMesh(const std::shared_ptr<Mesh>& mesh, const py::object& start,
                                       const py::object& target, std::optional<double> reach) {
  const double within = reachFrom(reach, std::numeric_limits<double>::infinity());
  return findPath(*finderOf(*mesh), start, target, within);
}

std::shared_ptr<PathResult> findOnArea(const std::shared_ptr<Area>& area, const py::object& start,
                                       const py::object& target, std::optional<double> reach) {
  const double within = reachFrom(reach, placeReach(area->pipeline));
  const auto finder = finderOf(*area);
  const auto path = findPath(*finder, start, target, within);
  if (path->status == PathStatus::NotConnected) {
    const auto separations = separationsOf(*area, *finder);
    interruptible(py::none(), [&](RunContext& context) {
      addSeparation(*path, *separations, &context);
      return true;
    });
  }
  return path;
}

void bindSeparation(py::module_& module) {
  py::class_<BorderLink>(module, "BorderLink",
                         R"(Where a border of the walkable area is near another one, and what an agent would have to
overcome there. Lengths are in the units of the environment.)")
      .def_property_readonly(
          "start", [](const BorderLink& l) { return arrayOf(l.from); }, "Shape (3,), float64.")
      .def_property_readonly(
          "end", [](const BorderLink& l) { return arrayOf(l.to); }, "Shape (3,), float64.")
      .def_property_readonly(
          "gap", [](const BorderLink& l) { return l.gap; }, "Between both, seen from above.")
      .def_property_readonly(
          "rise", [](const BorderLink& l) { return l.rise; }, "From start to end, upwards.")
      .def_property_readonly(
          "kind", [](const BorderLink& l) { return linkWord(l.kind); },
          R"(What stands between: "open" (nothing: a step, a gap, or both), "obstacle" (lower than
the agent), "low_ceiling", "wall" (as high as the agent), or "touch" (both meet in one
point only).)")
      .def_property_readonly(
          "obstacle", [](const BorderLink& l) { return l.obstacle; },
          "Of an \"obstacle\": its height over the lower place.")
      .def_property_readonly(
          "headroom", [](const BorderLink& l) { return l.headroom; },
          "Of a \"low_ceiling\": the free height over the higher place.")
      .def_property_readonly(
          "excess", [](const BorderLink& l) { return l.excess; },
          R"(What the agent lacks: the largest of the gap, of the height that is climbed beyond its step, and
of the height that a ceiling lacks.)")
      .def_property_readonly(
          "triangles", [](const BorderLink& l) { return l.triangles; },
          "What stands there, such as the riser of a step: a list of indices into the environment's triangles.")
      .def_property_readonly("size", &BorderLink::size, "The larger of the gap and of the height that is climbed.")
      .def_property_readonly("is_blocked", &BorderLink::isBlocked, "Whether no step or jump gets over it.")
      .def("__repr__", [](const BorderLink& l) {
        return "<footfall.BorderLink " + std::string(linkWord(l.kind)) + ": gap " +
               std::string(py::str(py::float_(l.gap))) + ", rise " + std::string(py::str(py::float_(l.rise))) + ">";
      });
}

void bindPath(py::module_& module) {
  py::class_<PathResult, std::shared_ptr<PathResult>> path(
      module, "Path",
      R"(A shortest path over a walkable area, or why there is none; str(path) is for people.

Where the target cannot be reached, the path leads to the place nearest to it that can be.)");
  path.def_property_readonly(
          "status", [](const PathResult& p) { return statusWord(p.status); },
          R"("found", "nothing_walkable", "start_not_walkable", "target_not_walkable" (no walkable
place within reach) or "not_connected".)")
      .def_property_readonly("reached", &PathResult::reached, "Whether the status is \"found\".")
      .def_property_readonly(
          "message", [](const PathResult& p) { return formatFailure(p, UpAxis::Z); },
          "Why the target is not reached, in one line; empty where it is.")
      .def_property_readonly(
          "points", [](const std::shared_ptr<PathResult>& p) { return viewOf(p->points, baseOf<PathResult>(p)); },
          "Shape (k, 3), float64: the path on the surface; none without a path. A view.")
      .def_property_readonly(
          "triangles", [](const std::shared_ptr<PathResult>& p) { return viewOf(p->triangles, baseOf<PathResult>(p)); },
          "Shape (k - 1,), uint32: the triangle that each piece lies in. A view.")
      .def_property_readonly(
          "bends", [](const PathResult& p) { return p.bends; },
          "Rows of `points` at which it turns around a corner: a list of int.")
      .def_property_readonly(
          "drops", [](const PathResult& p) { return p.drops; },
          "Pieces that are drops, one way down: a list of int; piece i goes from row i of `points` to the next one.")
      .def_property_readonly(
          "leads_back", [](const PathResult& p) { return p.leadsBack; },
          "Whether, where the status is \"not_connected\", drops lead from the target to the start.")
      .def_property_readonly(
          "length", [](const PathResult& p) { return p.length; }, "Of this path in space.")
      .def_property_readonly(
          "plan_length", [](const PathResult& p) { return p.planLength; },
          "Seen from above: the shortest there is, up to rounding; over drops, see `least_plan_length`.")
      .def_property_readonly(
          "least_plan_length", [](const PathResult& p) { return p.leastPlanLength; },
          "What no way to the same end is shorter than, seen from above: `plan_length`, or what is proven over drops.")
      .def_property_readonly(
          "layers", [](const PathResult& p) { return p.layers; },
          "Layers in the order in which the path passes them: a list of int.")
      .def_property_readonly(
          "max_slope", [](const PathResult& p) { return p.maxSlopeDegrees; },
          "Of the steepest triangle that it crosses, degrees.")
      .def_property_readonly(
          "max_incline", [](const PathResult& p) { return p.maxInclineDegrees; },
          "The steepest that it goes up or down itself, degrees.")
      .def_property_readonly(
          "start", [](const PathResult& p) { return placeOf(p.start); },
          R"(Shape (3,): where it starts, or the nearest walkable place to the start that was asked
for; None where nothing is walkable.)")
      .def_property_readonly(
          "end", [](const PathResult& p) { return placeOf(p.end); }, "Shape (3,): where it ends; None without a path.")
      .def_property_readonly(
          "separation",
          [](const PathResult& p) -> std::optional<std::vector<BorderLink>> {
            if (!p.separation) return std::nullopt;
            return p.separation->links;
          },
          R"(The obstacles between start and target: a list of `BorderLink` that leads from part to part, chosen so that the
largest of them is least. None where nothing does, and on a mesh that knows no environment.)")
      .def_property_readonly(
          "other_ways",
          [](const PathResult& p) -> std::optional<std::vector<BorderLink>> {
            if (!p.separation) return std::nullopt;
            return p.separation->others;
          },
          R"(Other places where mending one thing would join both parts as well, a list of `BorderLink`, least first:
those that lack at most twice as much as `barrier`, or a sixteenth of the agent's height. None where `separation` is.)")
      .def_property_readonly(
          "barrier",
          [](const PathResult& p) -> std::optional<BorderLink> {
            if (!p.separation) return std::nullopt;
            return p.separation->barrier();
          },
          "The largest of `separation`: what to mend first. None where there is none.")
      .def("__str__",
           [](const PathResult& p) {
             const std::string failure = formatFailure(p, UpAxis::Z);
             return (failure.empty() ? failure : failure + "\n") + formatPath(p, UpAxis::Z);
           })
      .def("__repr__", [](const PathResult& p) {
        return "<footfall.Path " + std::string(statusWord(p.status)) + ": length " +
               std::string(py::str(py::float_(p.length))) + ">";
      });
}

}  // namespace

std::shared_ptr<const PathFinder> finderOf(Mesh& mesh) {
  if (!mesh.finder)
    mesh.finder = interruptible(py::none(), [&data = mesh.data](RunContext& context) {
      return std::make_shared<const PathFinder>(data, &context);
    });
  return mesh.finder;
}

namespace {

void preparePaths(const std::shared_ptr<Mesh>& mesh, const std::shared_ptr<Mesh>& before) {
  if (!before || !before->finder || mesh->finder) {
    finderOf(*mesh);
    return;
  }
  mesh->finder = interruptible(py::none(), [&data = mesh->data, known = before->finder](RunContext& context) {
    return std::make_shared<const PathFinder>(data, *known, &context);
  });
}

}  // namespace

double reachFrom(std::optional<double> reach, double otherwise) {
  if (reach && !(*reach >= 0)) throw InputError("reach: must be a height that is not negative");
  return reach.value_or(otherwise);
}

void bindPaths(py::module_& module) {
  bindSeparation(module);
  bindPath(module);
  auto mesh = static_cast<py::class_<Mesh, std::shared_ptr<Mesh>>>(module.attr("NavigationMesh"));
  define(mesh, "find_path", &findOnMesh,
         R"(Return the shortest `Path` in the plan from the walkable place at `start` to that at `target`.

start, target: three numbers, Z up. A point means the walkable place straight above or below it that is
    nearest.
reach: how far above or below it may be; None: as far as you like.

The first call prepares the mesh (60,000 triangles take some 30 ms). Raises InputError for points that are not
finite.)",
         py::arg("start"), py::arg("target"), py::kw_only(), py::arg("reach") = py::none());
  define(mesh, "prepare_paths", &preparePaths,
         R"(Prepare the mesh for paths and rays, which otherwise the first call of `find_path` and its like does.

before: the result before an edit. What was prepared for it and is still valid is taken over, which takes a fraction of
    the time. Paths are the same.)",
         py::kw_only(), py::arg("before") = py::none());
  auto area = static_cast<py::class_<Area, Mesh, std::shared_ptr<Area>>>(module.attr("WalkableArea"));
  define(area, "find_path", &findOnArea,
         R"(As `NavigationMesh.find_path`, but where start and target are not connected, the path says what keeps them
apart, and `reach` is by default just less than the agent's height: a point on an obstacle never means the
floor beneath it.)",
         py::arg("start"), py::arg("target"), py::kw_only(), py::arg("reach") = py::none());
}

}  // namespace footfall::python
