// SPDX-License-Identifier: GPL-3.0-or-later
#include "pickling.hpp"

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "footfall/errors.hpp"

namespace footfall::python {
namespace {

constexpr int kVersion = 1;

void refuse(const std::string& what) {
  throw InputError("pickle: " + what + "; make it again with this version of Footfall");
}

template <class Value>
py::bytes bytesOf(const std::vector<Value>& values) {
  static_assert(std::has_unique_object_representations_v<Value> || std::is_same_v<Value, Vec3> ||
                std::is_same_v<Value, double>);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

template <class Value>
std::vector<Value> vectorFrom(const py::handle& given) {
  const std::string_view bytes = py::cast<py::bytes>(given);
  if (bytes.size() % sizeof(Value) != 0) refuse("an array has bytes left over");
  std::vector<Value> values(bytes.size() / sizeof(Value));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

std::string nameFrom(const py::handle& given) { return py::cast<py::bytes>(given); }

void checkVersion(const py::dict& state) {
  if (!state.contains("version") || py::cast<int>(state["version"]) != kVersion) refuse("its version is another one");
}

/// Numbers that must be below a count.
template <class Numbers>
void checkBelow(const Numbers& numbers, std::size_t count) {
  for (const std::uint32_t number : numbers)
    if (number >= count) refuse("a number is out of range");
}

UpAxis axisFrom(const py::handle& given) {
  const int axis = py::cast<int>(given);
  if (axis < 0 || axis > static_cast<int>(UpAxis::NegativeX)) refuse("its up axis is none");
  return static_cast<UpAxis>(axis);
}

py::list listOf(const std::vector<Storey>& storeys) {
  py::list list;
  for (const Storey& storey : storeys) list.append(py::make_tuple(py::bytes(storey.name), storey.height));
  return list;
}

std::vector<Storey> storeysFrom(const py::handle& given) {
  std::vector<Storey> storeys;
  for (const py::handle item : given) {
    const auto pair = py::cast<py::tuple>(item);
    storeys.push_back({nameFrom(pair[0]), py::cast<double>(pair[1])});
  }
  return storeys;
}

py::tuple tupleOf(const SkippedElements& skipped) {
  py::list listed;
  for (const SkippedPolygon& p : skipped.listed)
    listed.append(py::make_tuple(static_cast<int>(p.reason), p.cornerCount, p.line, p.face, py::bytes(p.mesh),
                                 bytesOf(p.corners)));
  return py::make_tuple(skipped.points, skipped.lines, skipped.polygons, listed);
}

SkippedElements skippedFrom(const py::tuple& given) {
  SkippedElements skipped;
  skipped.points = py::cast<std::uint64_t>(given[0]);
  skipped.lines = py::cast<std::uint64_t>(given[1]);
  skipped.polygons = py::cast<std::uint64_t>(given[2]);
  for (const py::handle item : given[3]) {
    const auto p = py::cast<py::tuple>(item);
    const int reason = py::cast<int>(p[0]);
    if (reason < 0 || reason > static_cast<int>(SkipReason::FreeForm)) refuse("a polygon was left out for no reason");
    skipped.listed.push_back({static_cast<SkipReason>(reason), py::cast<std::size_t>(p[1]),
                              py::cast<std::uint64_t>(p[2]), py::cast<std::uint64_t>(p[3]), nameFrom(p[4]),
                              vectorFrom<Vec3>(p[5])});
  }
  return skipped;
}

py::tuple tupleOf(const CoordinateGrid& g) {
  return py::make_tuple(g.step, g.bits, g.largestMovement, g.weldedVertices, g.degenerateTriangles, g.splitTriangles);
}

CoordinateGrid gridFrom(const py::tuple& g) {
  return {py::cast<double>(g[0]),        py::cast<std::uint32_t>(g[1]), py::cast<double>(g[2]),
          py::cast<std::uint64_t>(g[3]), py::cast<std::uint64_t>(g[4]), py::cast<std::uint64_t>(g[5])};
}

py::tuple tupleOf(const SourceFrame& frame) {
  return py::make_tuple(py::bytes(frame.source), static_cast<int>(frame.up), frame.metresPerUnit,
                        listOf(frame.storeys));
}

SourceFrame frameFrom(const py::tuple& frame) {
  return {nameFrom(frame[0]), axisFrom(frame[1]), py::cast<double>(frame[2]), storeysFrom(frame[3])};
}

/// Whole numbers of each link, and its height and width.
py::tuple tupleOf(const std::vector<StepLink>& links) {
  std::vector<std::uint32_t> numbers;
  std::vector<double> sizes;
  for (const StepLink& l : links) {
    numbers.insert(numbers.end(), {l.from[0], l.from[1], l.to[0], l.to[1], l.fromTriangle, l.toTriangle,
                                   static_cast<std::uint32_t>(l.kind)});
    sizes.insert(sizes.end(), {l.height, l.width});
  }
  return py::make_tuple(bytesOf(numbers), bytesOf(sizes));
}

std::vector<StepLink> linksFrom(const py::tuple& given) {
  const auto numbers = vectorFrom<std::uint32_t>(given[0]);
  const auto sizes = vectorFrom<double>(given[1]);
  if (numbers.size() % 7 != 0 || sizes.size() != numbers.size() / 7 * 2) refuse("its links do not fit together");
  std::vector<StepLink> links;
  for (std::size_t i = 0; i < numbers.size() / 7; ++i) {
    const std::uint32_t* n = &numbers[7 * i];
    links.push_back({{n[0], n[1]},
                     {n[2], n[3]},
                     n[4],
                     n[5],
                     sizes[2 * i],
                     sizes[2 * i + 1],
                     n[6] == 0 ? StepKind::Step : StepKind::Gap});
  }
  return links;
}

py::tuple tupleOf(const std::vector<DropLink>& drops) {
  std::vector<std::uint32_t> numbers;
  std::vector<Vec3> places;
  std::vector<double> sizes;
  for (const DropLink& d : drops) {
    numbers.insert(numbers.end(), {d.from[0], d.from[1], d.fromTriangle, d.toTriangle});
    places.insert(places.end(), {d.start[0], d.start[1], d.landing[0], d.landing[1]});
    sizes.insert(sizes.end(), {d.depth, d.width});
  }
  return py::make_tuple(bytesOf(numbers), bytesOf(places), bytesOf(sizes));
}

std::vector<DropLink> dropsFrom(const py::tuple& given) {
  const auto numbers = vectorFrom<std::uint32_t>(given[0]);
  const auto places = vectorFrom<Vec3>(given[1]);
  const auto sizes = vectorFrom<double>(given[2]);
  if (numbers.size() % 4 != 0 || places.size() != numbers.size() || sizes.size() != numbers.size() / 2)
    refuse("its drops do not fit together");
  std::vector<DropLink> drops;
  for (std::size_t i = 0; i < numbers.size() / 4; ++i) {
    const std::uint32_t* n = &numbers[4 * i];
    const Vec3* p = &places[4 * i];
    drops.push_back({{n[0], n[1]}, n[2], n[3], {p[0], p[1]}, {p[2], p[3]}, sizes[2 * i], sizes[2 * i + 1]});
  }
  return drops;
}

void checkMesh(const NavigationMesh& mesh) {
  const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
  for (const Triangle& t : mesh.triangles) checkBelow(t, vertices);
  for (const auto& edge : mesh.obstacleEdges) checkBelow(edge, vertices);
  for (const auto& edge : mesh.connections) checkBelow(edge, vertices);
  checkBelow(mesh.layers, mesh.layerCount);
  for (const StepLink& link : mesh.links) {
    checkBelow(std::array{link.from[0], link.from[1], link.to[0], link.to[1]}, vertices);
    checkBelow(std::array{link.fromTriangle, link.toTriangle}, triangles);
  }
  for (const DropLink& drop : mesh.drops) {
    checkBelow(drop.from, vertices);
    checkBelow(std::array{drop.fromTriangle, drop.toTriangle}, triangles);
  }
  if ((!mesh.layers.empty() && mesh.layers.size() != triangles) ||
      (!mesh.sourceTriangles.empty() && mesh.sourceTriangles.size() != triangles))
    refuse("its arrays do not fit together");
}

}  // namespace

py::dict stateOf(const Environment& e) {
  py::list parts, notes;
  for (const EnvironmentPart& part : e.parts)
    parts.append(py::make_tuple(py::bytes(part.mesh), py::bytes(part.material)));
  for (const Text& note : e.notes) notes.append(py::bytes(note.str()));
  py::dict state;
  state["version"] = kVersion;
  state["source"] = py::bytes(e.source);
  state["origin"] = py::bytes(e.origin);
  state["vertices"] = bytesOf(e.vertices);
  state["triangles"] = bytesOf(e.triangles);
  state["frame"] = py::make_tuple(static_cast<int>(e.up), e.upGuessed, e.metresPerUnit, e.scaleGuessed, e.bothSides);
  state["skipped"] = tupleOf(e.skipped);
  state["parts"] = parts;
  state["part_of"] = bytesOf(e.partOf);
  state["usual_roles"] = bytesOf(e.usualRoles);
  state["obstacle_only"] = bytesOf(e.obstacleOnly);
  state["storeys"] = listOf(e.storeys);
  state["notes"] = notes;
  state["grid"] = tupleOf(e.grid);
  return state;
}

std::shared_ptr<Environment> environmentFromState(const py::dict& state) {
  checkVersion(state);
  auto e = std::make_shared<Environment>();
  e->source = nameFrom(state["source"]);
  e->origin = nameFrom(state["origin"]);
  e->vertices = vectorFrom<Vec3>(state["vertices"]);
  e->triangles = vectorFrom<Triangle>(state["triangles"]);
  const auto frame = py::cast<py::tuple>(state["frame"]);
  e->up = axisFrom(frame[0]);
  e->upGuessed = py::cast<bool>(frame[1]);
  e->metresPerUnit = py::cast<double>(frame[2]);
  e->scaleGuessed = py::cast<bool>(frame[3]);
  e->bothSides = py::cast<bool>(frame[4]);
  e->skipped = skippedFrom(state["skipped"]);
  for (const py::handle item : state["parts"]) {
    const auto part = py::cast<py::tuple>(item);
    e->parts.push_back({nameFrom(part[0]), nameFrom(part[1])});
  }
  e->partOf = vectorFrom<std::uint32_t>(state["part_of"]);
  checkBelow(e->partOf, e->parts.size());
  e->usualRoles = vectorFrom<PartRole>(state["usual_roles"]);
  e->obstacleOnly = vectorFrom<std::uint8_t>(state["obstacle_only"]);
  e->storeys = storeysFrom(state["storeys"]);
  for (const py::handle note : state["notes"]) e->notes.emplace_back(nameFrom(note));
  e->grid = gridFrom(state["grid"]);
  checkEnvironment(*e);
  return e;
}

py::dict stateOf(const NavigationMesh& mesh) {
  py::dict state;
  state["version"] = kVersion;
  state["vertices"] = bytesOf(mesh.vertices);
  state["triangles"] = bytesOf(mesh.triangles);
  state["layers"] = bytesOf(mesh.layers);
  state["layer_count"] = mesh.layerCount;
  state["source_triangles"] = bytesOf(mesh.sourceTriangles);
  state["obstacle_edges"] = bytesOf(mesh.obstacleEdges);
  state["connections"] = bytesOf(mesh.connections);
  state["links"] = tupleOf(mesh.links);
  state["frame"] = tupleOf(mesh.frame);
  state["drops"] = tupleOf(mesh.drops);
  return state;
}

std::shared_ptr<const NavigationMesh> meshFromState(const py::dict& state) {
  checkVersion(state);
  auto mesh = std::make_shared<NavigationMesh>();
  mesh->vertices = vectorFrom<Vec3>(state["vertices"]);
  mesh->triangles = vectorFrom<Triangle>(state["triangles"]);
  mesh->layers = vectorFrom<std::uint32_t>(state["layers"]);
  mesh->layerCount = py::cast<std::uint32_t>(state["layer_count"]);
  mesh->sourceTriangles = vectorFrom<std::uint32_t>(state["source_triangles"]);
  mesh->obstacleEdges = vectorFrom<std::array<std::uint32_t, 2>>(state["obstacle_edges"]);
  mesh->connections = vectorFrom<std::array<std::uint32_t, 2>>(state["connections"]);
  mesh->links = linksFrom(state["links"]);
  mesh->frame = frameFrom(state["frame"]);
  mesh->drops = dropsFrom(state["drops"]);
  checkMesh(*mesh);
  return mesh;
}

py::tuple stateOf(const Component& c) {
  return py::make_tuple(c.area, c.triangles, bytesOf(std::vector{c.lower, c.upper, c.centre}), bytesOf(c.layers),
                        c.firstTriangle);
}

Component componentFromState(const py::tuple& state) {
  if (state.size() != 5) refuse("a component does not have five parts");
  const auto places = vectorFrom<Vec3>(state[2]);
  if (places.size() != 3) refuse("a component does not have three places");
  return {py::cast<double>(state[0]),          py::cast<std::size_t>(state[1]),  places[0], places[1], places[2],
          vectorFrom<std::uint32_t>(state[3]), py::cast<std::uint32_t>(state[4])};
}

}  // namespace footfall::python
