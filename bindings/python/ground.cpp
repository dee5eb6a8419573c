// Places, rays, many paths, single layers, polygons.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/ground.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/errors.hpp"
#include "footfall/path.hpp"
#include "footfall/plan_areas.hpp"
#include "interruptible.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

constexpr std::size_t kMostPlaces = 1'000'000'000;

using SharedMesh = std::shared_ptr<Mesh>;
using MeshClass = py::class_<Mesh, std::shared_ptr<Mesh>>;
using AreaClass = py::class_<Area, Mesh, std::shared_ptr<Area>>;

/// A ray, and the places of the border that stops it.
struct Ray {
  GroundRay found;
  std::shared_ptr<const NavigationMesh> mesh;
};

double usualReach(const Mesh& /*mesh*/) { return std::numeric_limits<double>::infinity(); }
double usualReach(const Area& area) { return placeReach(area.pipeline); }

/// One place, or one for each path.
std::vector<Vec3> placesFrom(const py::object& given, const std::string& name) {
  const py::array array = given.is_none() ? py::array() : py::array::ensure(given);
  if (array && array.size() == 0) return {};
  if (array && array.ndim() == 1 && array.shape(0) == 3) return {pointFrom(given, name)};
  return pointsFrom(given, name);
}

std::vector<std::array<Vec3, 2>> pairsFrom(const py::object& starts, const py::object& targets) {
  std::vector<Vec3> from = placesFrom(starts, "starts"), to = placesFrom(targets, "targets");
  if (from.size() == 1) from.resize(to.size(), from.front());
  if (to.size() == 1) to.resize(from.size(), to.front());
  if (from.size() != to.size())
    throw InputError("targets: there are " + std::to_string(to.size()) + " for " + std::to_string(from.size()) +
                     " starts; give as many, or one place for all");
  std::vector<std::array<Vec3, 2>> pairs;
  for (std::size_t i = 0; i < from.size(); ++i) pairs.push_back({from[i], to[i]});
  return pairs;
}

template <class Self>
std::vector<std::shared_ptr<PathResult>> pathsOn(const std::shared_ptr<Self>& mesh, const py::object& starts,
                                                 const py::object& targets, std::optional<double> reach,
                                                 const py::object& progress) {
  const double within = reachFrom(reach, usualReach(*mesh));
  const auto pairs = pairsFrom(starts, targets);
  const auto finder = finderOf(*mesh);
  auto found = interruptible(
      progress, [&](RunContext& context) { return footfall::findPaths(*finder, pairs, within, &context); });
  std::vector<std::shared_ptr<PathResult>> paths;
  for (PathResult& path : found) paths.push_back(std::make_shared<PathResult>(std::move(path)));
  return paths;
}

template <class Self>
std::optional<SurfacePlace> placeAt(const std::shared_ptr<Self>& mesh, const py::object& point,
                                    std::optional<double> reach) {
  const double within = reachFrom(reach, usualReach(*mesh));
  return finderOf(*mesh)->locate(pointFrom(point, "point"), within);
}

Ray rayFrom(const SharedMesh& mesh, const SurfacePlace& place, const py::object& target) {
  return {footfall::castRayFrom(*finderOf(*mesh), place, pointFrom(target, "target")), mesh->data};
}

template <class Self>
std::optional<Ray> rayOn(const std::shared_ptr<Self>& mesh, const py::object& start, const py::object& target,
                         std::optional<double> reach) {
  const double within = reachFrom(reach, usualReach(*mesh));
  const Vec3 from = pointFrom(start, "start"), to = pointFrom(target, "target");
  auto ray = footfall::castRay(*finderOf(*mesh), from, to, within);
  if (!ray) return std::nullopt;
  return Ray{*std::move(ray), mesh->data};
}

py::array rowsOf(const std::vector<Vec3>& points) {
  auto shared = std::make_shared<const std::vector<Vec3>>(points);
  return viewOf(*shared, baseOf(shared)).attr("copy")();
}

py::array randomOn(const SharedMesh& mesh, std::size_t count, std::uint64_t seed) {
  if (count > kMostPlaces)
    throw InputError("count: " + std::to_string(count) + " places are too many; give " + std::to_string(kMostPlaces) +
                     " at most");
  const auto places = footfall::randomPlaces(*finderOf(*mesh), count, seed);
  std::vector<Vec3> points;
  points.reserve(places.size());
  for (const SurfacePlace& place : places) points.push_back(place.position);
  return rowsOf(points);
}

std::string shortText(double value) { return py::str(py::float_(value)); }

void bindPlace(py::module_& module) {
  py::class_<SurfacePlace>(module, "Place", "A walkable place.")
      .def_property_readonly(
          "position", [](const SurfacePlace& p) { return arrayOf(p.position); }, "Shape (3,), float64.")
      .def_property_readonly(
          "triangle", [](const SurfacePlace& p) { return p.triangle; }, "The row of `NavigationMesh.triangles`.")
      .def_property_readonly(
          "distance", [](const SurfacePlace& p) { return p.distance; }, "From the point that was given.")
      .def("__repr__", [](const SurfacePlace& p) {
        return "<footfall.Place " + shortText(p.position.x) + " " + shortText(p.position.y) + " " +
               shortText(p.position.z) + ">";
      });
  py::class_<Ray>(module, "Ray", "A straight way over the ground, seen from above: what `cast_ray` returns.")
      .def_property_readonly(
          "reached", [](const Ray& r) { return r.found.reached; }, "Whether the whole way is walkable.")
      .def_property_readonly(
          "start", [](const Ray& r) { return arrayOf(r.found.start.position); }, "Shape (3,): where it starts.")
      .def_property_readonly(
          "end", [](const Ray& r) { return arrayOf(r.found.end.position); },
          "Shape (3,): the last walkable place, at the target or on the border that stops it.")
      .def_property_readonly(
          "start_place", [](const Ray& r) { return r.found.start; }, "The `Place` at the start.")
      .def_property_readonly(
          "end_place", [](const Ray& r) { return r.found.end; },
          "The `Place` at the end, from which `cast_ray_from` goes on; its `distance` is that to the target, seen from "
          "above.")
      .def_property_readonly(
          "plan_length", [](const Ray& r) { return r.found.planLength; }, "From start to end, seen from above.")
      .def_property_readonly(
          "border",
          [](const Ray& r) -> py::object {
            if (!r.found.border) return py::none();
            const auto& [first, second] = *r.found.border;
            return rowsOf({r.mesh->vertices[first], r.mesh->vertices[second]});
          },
          "Shape (2, 3): the ends of the edge that stops it; None where it is not stopped, or stopped at a corner.")
      .def_property_readonly(
          "triangles", [](const Ray& r) { return r.found.triangles; },
          "The rows of `NavigationMesh.triangles` under the way, in its order: a list of int.")
      .def("__repr__", [](const Ray& r) {
        return std::string("<footfall.Ray ") + (r.found.reached ? "reached" : "stopped") + ": plan length " +
               shortText(r.found.planLength) + ">";
      });
}

/// Defines the functions with a reach, whose default differs for areas.
template <class Self, class Class>
void defineReaching(Class& type, const char* usual) {
  const std::string reach = std::string("\nreach: how far above or below it may be; None: ") + usual + ".\n";
  define(type, "find_paths", &pathsOn<Self>,
         (R"(Return the shortest paths for many pairs in one call, on all threads: a list of `Path`, in their order.

starts, targets: shape (n, 3), or one place for all. Each point means the walkable place straight above or below
    it that is nearest.)" +
          reach +
          R"(progress: as for `run`. Ctrl-C raises KeyboardInterrupt.

What keeps places apart is not looked for; `find_path` does that. Raises InputError.)")
             .c_str(),
         py::arg("starts"), py::arg("targets"), py::kw_only(), py::arg("reach") = py::none(),
         py::arg("progress") = py::none());
  define(type, "place_at", &placeAt<Self>,
         (R"(Return the walkable `Place` straight above or below a point that is nearest to it, or None.

point: three numbers, Z up.)" +
          reach + "\nWhich triangles lie there is decided exactly. Raises InputError.")
             .c_str(),
         py::arg("point"), py::kw_only(), py::arg("reach") = py::none());
  define(
      type, "cast_ray", &rayOn<Self>,
      (R"(Walk straight, seen from above, from the walkable place at `start` towards `target`, as far as the ground goes:
return a `Ray`, or None where no walkable place is at the start.

start, target: three numbers, Z up. The height of the target is not used.)" +
       reach +
       R"(
It follows the surface over edges, steps and gaps, never over drops, and ends at the first border. Which triangles it
crosses is decided exactly: it passes along borders, and past the end of a wall that it touches. Raises InputError.)")
          .c_str(),
      py::arg("start"), py::arg("target"), py::kw_only(), py::arg("reach") = py::none());
}

py::list polygonsOf(const SharedMesh& mesh, std::optional<std::uint32_t> part) {
  const auto areas =
      interruptible(py::none(), [&](RunContext& context) { return planAreas(*mesh->data, part, &context); });
  py::list polygons;
  for (const PlanArea& area : areas) {
    py::list holes;
    for (const auto& hole : area.holes) holes.append(rowsOf(hole));
    polygons.append(py::make_tuple(area.layer, area.part, rowsOf(area.outer), holes, area.area));
  }
  return polygons;
}

}  // namespace

void bindGround(py::module_& module) {
  bindPlace(module);
  auto mesh = static_cast<MeshClass>(module.attr("NavigationMesh"));
  auto area = static_cast<AreaClass>(module.attr("WalkableArea"));
  defineReaching<Mesh>(mesh, "as far as you like");
  defineReaching<Area>(area, "just less than the agent's height");
  define(
      mesh, "nearest_place",
      [](const SharedMesh& m, const py::object& point) {
        return footfall::nearestPlace(*finderOf(*m), pointFrom(point, "point"));
      },
      R"(Return the walkable `Place` that is nearest to a point, in space; None where nothing is walkable.

point: three numbers, Z up. Raises InputError.)",
      py::arg("point"));
  define(mesh, "cast_ray_from", &rayFrom,
         R"(Walk straight, seen from above, from a `Place` towards `target`, as `cast_ray` does: return a `Ray`.

place: a `Place` of this mesh, such as `Ray.end_place`. target: three numbers, whose height is not used.

The ray starts in the triangle of the place, whatever else lies there, so that rays in a row never pass a wall
without thickness. Raises InputError.)",
         py::arg("place"), py::arg("target"));
  define(mesh, "random_places", &randomOn,
         R"(Return random walkable places, evenly by the area of the surface: an array of shape (count, 3).

count: how many. seed: a number of your choice; the same one gives the same places on every machine, and fewer
    places are the first of more.

Each lies on its triangle exactly, seen from above. Raises InputError where nothing is walkable.)",
         py::arg("count"), py::arg("seed") = 0);
  define(
      mesh, "layer",
      [](const SharedMesh& m, std::uint32_t number) {
        auto data = std::make_shared<const NavigationMesh>(layerOf(*m->data, number));
        return std::make_shared<Mesh>(
            Mesh{std::move(data), nullptr, "layer " + std::to_string(number) + " of " + m->label});
      },
      R"(Return one layer as a `NavigationMesh` of its own, with the vertices that it uses.

number: from 0 to `layer_count` - 1. Links and drops stay where they are within the layer. Raises InputError.)",
      py::arg("number"));
  define(mesh, "_polygons", &polygonsOf, "(layer, part, outer ring, holes, area) of each polygon.", py::arg("part"));
}

}  // namespace footfall::python
