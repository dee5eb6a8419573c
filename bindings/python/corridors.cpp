// The corridor map: how wide every passage is, bottlenecks, and ways for a body.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "corridors.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "definitions.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "interruptible.hpp"
#include "texts.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

using SharedMap = std::shared_ptr<CorridorMap>;

/// A way, and the places along it.
struct Corridor {
  CorridorPath path;
  std::vector<Vec3> places;
};

template <class Item, class Value>
py::array_t<Value> column(const std::vector<Item>& items, Value Item::*member) {
  py::array_t<Value> values(static_cast<py::ssize_t>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) values.mutable_at(i) = items[i].*member;
  return values;
}

template <class Item>
py::array_t<double> placesOf(const std::vector<Item>& items, Vec3 Item::*member) {
  py::array_t<double> values({static_cast<py::ssize_t>(items.size()), py::ssize_t{3}});
  auto rows = values.mutable_unchecked<2>();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Vec3& p = items[i].*member;
    const auto row = static_cast<py::ssize_t>(i);
    rows(row, 0) = p.x;
    rows(row, 1) = p.y;
    rows(row, 2) = p.z;
  }
  return values;
}

py::array_t<std::uint32_t> endsOf(const CorridorMap& map) {
  py::array_t<std::uint32_t> values({static_cast<py::ssize_t>(map.edges.size()), py::ssize_t{2}});
  auto rows = values.mutable_unchecked<2>();
  for (std::size_t i = 0; i < map.edges.size(); ++i) {
    rows(static_cast<py::ssize_t>(i), 0) = map.edges[i].from;
    rows(static_cast<py::ssize_t>(i), 1) = map.edges[i].to;
  }
  return values;
}

std::uint32_t vertexAt(const CorridorMap& map, const py::object& point, const char* name) {
  const Vec3 place = pointFrom(point, name);
  if (map.vertices.empty()) throw InputError(std::string(name) + ": the map has no places, as nothing is walkable");
  return nearestVertex(map, place);
}

std::optional<Corridor> corridorOf(const CorridorMap& map, CorridorPath path) {
  if (path.vertices.empty()) return std::nullopt;
  Corridor corridor{std::move(path), {}};
  for (const std::uint32_t vertex : corridor.path.vertices) corridor.places.push_back(map.vertices[vertex].place);
  return corridor;
}

void bindBottlenecks(py::module_& module) {
  py::class_<Bottleneck>(module, "Bottleneck",
                         "Where a passage is narrower than on either side. Lengths are in the plan.")
      .def_property_readonly(
          "place", [](const Bottleneck& b) { return arrayOf(b.place); }, "Shape (3,), float64.")
      .def_property_readonly(
          "width", [](const Bottleneck& b) { return b.width; }, "How wide it is.")
      .def_property_readonly(
          "left", [](const Bottleneck& b) { return arrayOf(b.left); },
          "Shape (3,): the place of the border on one side.")
      .def_property_readonly(
          "right", [](const Bottleneck& b) { return arrayOf(b.right); }, "The same on the other side.")
      .def_property_readonly(
          "edge", [](const Bottleneck& b) { return b.edge; }, "The row of `CorridorMap.edges` that it lies on.")
      .def_property_readonly(
          "is_only_way", [](const Bottleneck& b) { return b.isOnlyWay; }, "Whether no other way leads past it.")
      .def_property_readonly(
          "areas", [](const Bottleneck& b) { return py::make_tuple(b.sides[0].area, b.sides[1].area); },
          "Where it is the only way: the areas on both sides, in the plan; (0.0, 0.0) elsewhere.")
      .def("__repr__", [](const Bottleneck& b) {
        return "<footfall.Bottleneck: width " + std::string(py::str(py::float_(b.width))) + ">";
      });
  py::class_<Corridor>(module, "Corridor", "A way along a `CorridorMap`, in the middle of its passages.")
      .def_property_readonly(
          "points",
          [](const Corridor& c) {
            auto shared = std::make_shared<const std::vector<Vec3>>(c.places);
            return viewOf(*shared, baseOf(shared));
          },
          "Shape (k, 3), float64: the places of the map along it.")
      .def_property_readonly(
          "vertices", [](const Corridor& c) { return c.path.vertices; }, "Rows of `CorridorMap.places`: a list of int.")
      .def_property_readonly(
          "edges", [](const Corridor& c) { return c.path.edges; }, "Rows of `CorridorMap.edges`: a list of int.")
      .def_property_readonly(
          "length", [](const Corridor& c) { return c.path.length; }, "In the plan.")
      .def_property_readonly(
          "width", [](const Corridor& c) { return c.path.width; }, "Where it is narrowest.")
      .def("__repr__", [](const Corridor& c) {
        return "<footfall.Corridor: length " + std::string(py::str(py::float_(c.path.length))) + ", width " +
               std::string(py::str(py::float_(c.path.width))) + ">";
      });
}

void bindMap(py::class_<CorridorMap, SharedMap>& map) {
  map.def_property_readonly(
         "places", [](const CorridorMap& m) { return placesOf(m.vertices, &CorridorVertex::place); },
         "Shape (n, 3), float64: where edges end, or their nearest borders change.")
      .def_property_readonly(
          "widths", [](const CorridorMap& m) { return column(m.vertices, &CorridorVertex::width); },
          "Shape (n,), float64: twice the distance of each place to the nearest border.")
      .def_property_readonly("edges", &endsOf, "Shape (k, 2), uint32: rows of `places`.")
      .def_property_readonly(
          "edge_widths", [](const CorridorMap& m) { return column(m.edges, &CorridorEdge::width); },
          "Shape (k,), float64: of each edge where it is narrowest.")
      .def_property_readonly(
          "edge_lengths", [](const CorridorMap& m) { return column(m.edges, &CorridorEdge::length); },
          "Shape (k,), float64.")
      .def_property_readonly(
          "narrowest", [](const CorridorMap& m) { return placesOf(m.edges, &CorridorEdge::narrowest); },
          "Shape (k, 3), float64: where each edge is narrowest.")
      .def_property_readonly(
          "bottlenecks", [](const CorridorMap& m) { return m.bottlenecks; },
          "A list of `Bottleneck`, the narrowest first.")
      .def("__repr__", [](const CorridorMap& m) {
        return "<footfall.CorridorMap: " + std::to_string(m.vertices.size()) + " places, " +
               std::to_string(m.edges.size()) + " edges, " + std::to_string(m.bottlenecks.size()) + " bottlenecks>";
      });
  define(
      map, "shortest",
      [](const CorridorMap& m, const py::object& start, const py::object& target, double width) {
        if (!(width >= 0)) throw InputError("width: must be a length that is not negative");
        const std::uint32_t from = vertexAt(m, start, "start"), to = vertexAt(m, target, "target");
        return corridorOf(m, shortestCorridor(m, from, to, width));
      },
      R"(Return the shortest `Corridor` that is nowhere narrower than `width`; None where there is none.

start, target: three numbers, Z up; the nearest places of the map are meant. width: in the units of the environment.
Raises InputError, also where the map has no places.)",
      py::arg("start"), py::arg("target"), py::arg("width") = 0.0);
  define(
      map, "widest",
      [](const CorridorMap& m, const py::object& start, const py::object& target) {
        const std::uint32_t from = vertexAt(m, start, "start"), to = vertexAt(m, target, "target");
        return corridorOf(m, widestCorridor(m, from, to));
      },
      R"(Return the `Corridor` whose narrowest place is widest, and the shortest of those; None where there is none.

start, target: three numbers, Z up; the nearest places of the map are meant. Raises InputError, also where the map has no
places.)",
      py::arg("start"), py::arg("target"));
  define(
      map, "prominence",
      [](const CorridorMap& m, const Bottleneck& b) {
        if (b.sides[0].widest >= m.vertices.size() || b.sides[1].widest >= m.vertices.size())
          throw InputError("bottleneck: must be one of this map");
        return prominence(m, b);
      },
      R"(Return how much wider the way gets on the less wide side of a bottleneck, over its width: a float, 0.05 for 5 %.

bottleneck: one of this map. Of a passage with rough borders the narrowest place has a large one, the others have small
ones. Raises InputError where it is of a larger map.)",
      py::arg("bottleneck"));
  define(
      map, "to_json", [](const CorridorMap& m) { return shownText(formatCorridorsJson(m)); },
      "Return the map as JSON, as `footfall corridors` writes it: a str.");
  define(
      map, "to_geojson", [](const CorridorMap& m) { return shownText(formatCorridorsGeoJson(m)); },
      "Return the map as GeoJSON, edges and bottlenecks as lines in metres: a str.");
}

}  // namespace

void bindCorridors(py::module_& module) {
  bindBottlenecks(module);
  py::class_<CorridorMap, SharedMap> map(
      module, "CorridorMap",
      R"(The middle lines of all passages as a graph, over layers, steps and gaps (the Explicit Corridor Map), and its
bottlenecks. Lengths, widths and areas are in the plan, in the units of the environment.)");
  bindMap(map);
  auto mesh = static_cast<py::class_<Mesh, std::shared_ptr<Mesh>>>(module.attr("NavigationMesh"));
  define(
      mesh, "corridors",
      [](const std::shared_ptr<Mesh>& m, bool full) {
        return interruptible(py::none(), [&data = m->data, full](RunContext& context) {
          return std::make_shared<CorridorMap>(makeCorridorMap(*data, {full}, &context));
        });
      },
      R"(Return how wide every passage is: a `CorridorMap`.

full: keep the pieces that lead into corners, behind which there is no passage.)",
      py::kw_only(), py::arg("full") = false);
}

}  // namespace footfall::python
