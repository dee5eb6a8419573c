// Runs, and the meshes that they leave.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "runs.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/agent.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "footfall/up_axis.hpp"
#include "interruptible.hpp"
#include "pickling.hpp"
#include "texts.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

std::string statisticsTextOf(const Area& area) {
  return area.statistics ? *area.statistics : formatStatistics(*area.environment, area.result);
}

std::string summaryOf(const Area& area) {
  return area.summary ? *area.summary : formatSummary(*area.environment, area.result);
}

py::dict areaState(const Area& area) {
  py::dict state = stateOf(*area.data);
  state["environment"] = held(area.environment);
  state["pipeline"] = area.pipeline;
  state["area"] = area.result.summary.area;
  state["threads"] = area.result.threads;
  state["statistics"] = py::bytes(statisticsTextOf(area));
  state["summary"] = py::bytes(summaryOf(area));
  return state;
}

std::shared_ptr<Area> areaFromState(const py::dict& state) {
  auto area = std::make_shared<Area>();
  area->data = area->result.mesh = meshFromState(state);
  area->environment = py::cast<std::shared_ptr<Environment>>(state["environment"]);
  area->label = labelOf(*area->environment);
  area->pipeline = py::cast<Pipeline>(state["pipeline"]);
  area->agent = describeAgent(area->pipeline);
  area->result.summary.area = py::cast<double>(state["area"]);
  area->result.threads = py::cast<int>(state["threads"]);
  area->statistics = std::string(py::cast<py::bytes>(state["statistics"]));
  area->summary = std::string(py::cast<py::bytes>(state["summary"]));
  return area;
}

/// The statistics of a run as Python's own objects.
py::object statisticsOf(const Area& area) {
  return py::module_::import("json").attr("loads")(shownText(statisticsTextOf(area)));
}

/// Parts count from 0 in Python and from 1 in messages of the core.
void checkPart(const NavigationMesh& mesh, std::uint32_t part, RunContext& context) {
  const std::size_t count = findComponents(mesh, &context).list.size();
  if (part < count) return;
  throw InputError("part: there is no connected part " + std::to_string(part) + "; " +
                   (count > 0 ? "give a number from 0 to " + std::to_string(count - 1) : "nothing is walkable"));
}

double saveMesh(const NavigationMesh& mesh, const std::filesystem::path& path, const ExportHeader& header,
                const ExportOptions& options) {
  const std::string name = path.string();
  return interruptible(py::none(), [&](RunContext& context) {
    if (options.part) checkPart(mesh, *options.part, context);
    return save(mesh, name, options, header, {}, &context);
  });
}

/// Defines `save`, whose options are those of ExportOptions. `headerOf` gives the comments.
template <class Class, class HeaderOf>
void defineSave(Class& type, const char* documentation, HeaderOf headerOf) {
  using Self = typename Class::type;
  define(
      type, "save",
      [headerOf](const Self& self, const std::filesystem::path& path, bool layers, bool connections, bool obstacleEdges,
                 bool steps, bool drops, const std::optional<std::string>& up, double scale, int godot,
                 bool navmeshNode, std::optional<std::uint32_t> part, const std::optional<std::string>& system) {
        return saveMesh(*self.data, path, headerOf(self),
                        {layers, connections, obstacleEdges, steps, upAxisFrom(up), scale, drops, godot, navmeshNode,
                         part, system.value_or(std::string())});
      },
      documentation, py::arg("path"), py::kw_only(), py::arg("layers") = true, py::arg("connections") = true,
      py::arg("obstacle_edges") = true, py::arg("steps") = true, py::arg("drops") = true, py::arg("up") = py::none(),
      py::arg("scale") = 1.0, py::arg("godot") = 4, py::arg("navmesh_node") = false, py::arg("part") = py::none(),
      py::arg("coordinate_system") = py::none());
}

std::shared_ptr<Mesh> meshFrom(const py::object& vertices, const py::object& triangles, const py::object& layers) {
  auto mesh = std::make_shared<NavigationMesh>();
  mesh->vertices = pointsFrom(vertices, "vertices");
  mesh->triangles = trianglesFrom(triangles, "triangles", mesh->vertices.size());
  if (!layers.is_none()) {
    mesh->layers = numbersFrom(layers, "layers", mesh->triangles.size());
    for (const std::uint32_t layer : mesh->layers) mesh->layerCount = std::max(mesh->layerCount, layer + 1);
  }
  return std::make_shared<Mesh>(Mesh{std::move(mesh)});
}

py::array_t<std::uint32_t> linksOf(const Mesh& mesh) {
  const std::vector<StepLink>& links = mesh.data->links;
  py::array_t<std::uint32_t> rows({static_cast<py::ssize_t>(links.size()), py::ssize_t{4}});
  auto values = rows.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    const StepLink& link = links[static_cast<std::size_t>(i)];
    for (const py::ssize_t k : {0, 1}) {
      values(i, k) = link.from[static_cast<std::size_t>(k)];
      values(i, k + 2) = link.to[static_cast<std::size_t>(k)];
    }
  }
  return rows;
}

/// An array with a number of each link.
template <class Value, class Number>
auto linkArray(Number number) {
  return [number](const Mesh& mesh) {
    const std::vector<StepLink>& links = mesh.data->links;
    py::array_t<Value> rows(static_cast<py::ssize_t>(links.size()));
    auto values = rows.template mutable_unchecked<1>();
    for (py::ssize_t i = 0; i < values.shape(0); ++i) values(i) = number(links[static_cast<std::size_t>(i)]);
    return rows;
  };
}

/// Numbers of vertices and triangles of all drops.
py::array_t<std::uint32_t> dropsOf(const Mesh& mesh) {
  const std::vector<DropLink>& drops = mesh.data->drops;
  py::array_t<std::uint32_t> rows({static_cast<py::ssize_t>(drops.size()), py::ssize_t{4}});
  auto values = rows.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    const DropLink& drop = drops[static_cast<std::size_t>(i)];
    values(i, 0) = drop.from[0];
    values(i, 1) = drop.from[1];
    values(i, 2) = drop.fromTriangle;
    values(i, 3) = drop.toTriangle;
  }
  return rows;
}

py::array_t<double> dropPlacesOf(const Mesh& mesh) {
  const std::vector<DropLink>& drops = mesh.data->drops;
  py::array_t<double> places({static_cast<py::ssize_t>(drops.size()), py::ssize_t{4}, py::ssize_t{3}});
  auto values = places.mutable_unchecked<3>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    const DropLink& drop = drops[static_cast<std::size_t>(i)];
    py::ssize_t k = 0;
    for (const Vec3& p : {drop.start[0], drop.start[1], drop.landing[0], drop.landing[1]}) {
      values(i, k, 0) = p.x;
      values(i, k, 1) = p.y;
      values(i, k++, 2) = p.z;
    }
  }
  return places;
}

py::array_t<double> dropDepthsOf(const Mesh& mesh) {
  py::array_t<double> depths(static_cast<py::ssize_t>(mesh.data->drops.size()));
  auto values = depths.mutable_unchecked<1>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) values(i) = mesh.data->drops[static_cast<std::size_t>(i)].depth;
  return depths;
}

template <class Member>
auto meshView(Member NavigationMesh::*member) {
  return [member](const Mesh& mesh) { return viewOf(mesh.data.get()->*member, baseOf(mesh.data)); };
}

void bindMesh(py::module_& module) {
  py::class_<Mesh, std::shared_ptr<Mesh>> mesh(module, "NavigationMesh",
                                               R"(A walkable area as triangles. It never changes.

Z is up; coordinates and areas are in the units of the environment. Two triangles share a vertex by its number
exactly where an agent can cross; the two sides of an obstacle edge have vertices of their own. Arrays are views
without a copy that cannot be written to, and keep what they show alive.)");
  defineConstructor(
      mesh, &meshFrom,
      R"(Make a mesh of another program's arrays, which are copied, to look for paths on it or to compare it.

vertices: shape (n, 3), float64, Z up. triangles: shape (m, 3), integers, counter-clockwise seen from above.
layers: shape (m,), integers from 0, or None. Raises InputError.)",
      py::arg("vertices"), py::arg("triangles"), py::arg("layers") = py::none());
  mesh.def_property_readonly("vertices", meshView(&NavigationMesh::vertices), "Shape (n, 3), float64, Z up. A view.")
      .def_property_readonly("triangles", meshView(&NavigationMesh::triangles),
                             "Shape (m, 3), uint32: rows of `vertices`, counter-clockwise seen from above. A view.")
      .def_property_readonly(
          "layers",
          [](const Mesh& m) -> py::object {
            if (m.data->layers.empty()) return py::none();
            return viewOf(m.data->layers, baseOf(m.data));
          },
          R"(Shape (m,), uint32: the layer of each triangle, from 0; layers do not overlap themselves in the plan. None
where no layer filter ran. A view.)")
      .def_property_readonly(
          "layer_count", [](const Mesh& m) { return m.data->layerCount; }, "How many layers.")
      .def_property_readonly(
          "least_layers", [](const Mesh& m) { return leastLayers(*m.data); },
          "A proven lower bound of `layer_count`: the most triangles that were found over one place.")
      .def_property_readonly(
          "least_connections", [](const Mesh& m) { return leastConnections(*m.data); },
          "A proven lower bound of the number of connections: of each part that hangs together, the most triangles "
          "over one place, less one.")
      .def_property_readonly(
          "source_triangles",
          [](const Mesh& m) -> py::object {
            if (m.data->sourceTriangles.empty()) return py::none();
            return viewOf(m.data->sourceTriangles, baseOf(m.data));
          },
          R"(Shape (m,), uint32: of each triangle a triangle of the environment in whose plane it lies. None where the
mesh came from a file or from arrays. A view.)")
      .def_property_readonly("obstacle_edges", meshView(&NavigationMesh::obstacleEdges),
                             "Shape (k, 2), uint32: rows of `vertices`; edges inside that cannot be crossed. A view.")
      .def_property_readonly("connections", meshView(&NavigationMesh::connections),
                             "Shape (k, 2), uint32: rows of `vertices`; edges where two layers meet. A view.")
      .def_property_readonly(
          "links", &linksOf,
          R"(Shape (k, 4), uint32: rows of `vertices`; the steps and gaps of a StepFilter. Columns 0 and 1 are an edge
with the walkable area on its left, columns 2 and 3 the edge that one steps to, likewise: it lies over the first in the
plan, or over a gap beside it, and runs backwards.)")
      .def_property_readonly("link_heights", linkArray<double>([](const StepLink& link) { return link.height; }),
                             "Shape (k,), float64: how high each of `links` is, at most.")
      .def_property_readonly("link_widths", linkArray<double>([](const StepLink& link) { return link.width; }),
                             "Shape (k,), float64: how wide each of `links` is in the plan, at most; 0 for steps.")
      .def_property_readonly("link_is_gap",
                             linkArray<bool>([](const StepLink& link) { return link.kind == StepKind::Gap; }),
                             "Shape (k,), bool: whether each of `links` leads over a gap; the others are steps.")
      .def_property_readonly(
          "drops", &dropsOf,
          R"(Shape (k, 4), uint32: the drops of a DropFilter, one way. Columns 0 and 1, rows of `vertices`, are the edge
that one drops from, with the walkable area on its left; columns 2 and 3, rows of `triangles`, are the one with that
edge and the one in which one lands.)")
      .def_property_readonly(
          "drop_places", &dropPlacesOf,
          R"(Shape (k, 4, 3), float64: of each of `drops` both ends of the stretch of edge that one drops from, and the
places where one lands from them; in between both move evenly.)")
      .def_property_readonly("drop_depths", &dropDepthsOf, "Shape (k,), float64: how deep each of `drops` is, at most.")
      .def_property_readonly(
          "source", [](const Mesh& m) { return fileNameOf(m.data->frame.source); },
          "The file of the environment; empty where there was none.")
      .def_property_readonly(
          "up", [](const Mesh& m) { return nameOf(m.data->frame.up); },
          "The up axis of that file: \"z\", \"-y\", ...; `save` turns coordinates back to it.")
      .def_property_readonly(
          "metres_per_unit", [](const Mesh& m) { return m.data->frame.metresPerUnit; },
          "Metres for each unit of the coordinates.")
      .def("__repr__", [](const Mesh& m) { return "<footfall.NavigationMesh: " + sizesOf(*m.data) + ">"; })
      .def(py::pickle(
          [](const Mesh& m) {
            py::dict state = stateOf(*m.data);
            state["label"] = py::bytes(m.label);
            return state;
          },
          [](const py::dict& state) {
            return std::make_shared<Mesh>(Mesh{meshFromState(state), nullptr, py::cast<py::bytes>(state["label"])});
          }));
  defineCopies(mesh);
  defineSave(
      mesh,
      R"(Write the mesh, in the format that the ending of `path` asks for: OBJ (.obj) in the frame and units of the
environment's file; in metres and Y up glTF (.gltf, .glb), a tile set of Detour (.bin) or a NavigationMesh of Godot
(.tres); in metres and Z up polygons with holes (.wkt, a file for each layer and one for links; .geojson). A file that
is there is replaced as a whole, or stays as it was.

layers: a group for each layer. connections, obstacle_edges: their lines, too. steps: the faces of `links`, too.
drops: the lines of `drops`, too.
up: another up axis of an OBJ ("z", "y", "x", "-z", "-y", "-x"). scale: a factor for coordinates, above 0.
godot: the version that is to read a .tres, 3 or 4. navmesh_node: a glTF of one mesh, whose node Godot imports as a
navigation region. part: of polygons this connected part alone, as `components` number them. coordinate_system: of
.geojson the one that the environment is in already, such as "EPSG:25832".

Returns how far rounding moved a coordinate at most, in metres: 0.0 for OBJ and polygons; all others have floats of 32
bits. Raises InputError for another ending, scale or part and for options that the format knows nothing of, RunError
where the file cannot be written.)",
      [](const Mesh&) { return ExportHeader(); });
  define(
      module, "read_mesh",
      [](const std::filesystem::path& path, const std::optional<std::string>& up) {
        const std::optional<UpAxis> axis = upAxisFrom(up);
        return std::make_shared<Mesh>(
            Mesh{interruptible(py::none(),
                               [&](RunContext& context) {
                                 NavigationMeshFile file = readNavigationMesh(path.string(), axis, UpAxis::Y, &context);
                                 return std::make_shared<const NavigationMesh>(std::move(file.mesh));
                               }),
                 nullptr, "mesh of " + path.string()});
      },
      R"(Read a navigation mesh from an OBJ: one that Footfall wrote, with its layers, or any other surface; return a
`NavigationMesh`.

up: the file's up axis; None: what the file states, else "y". Raises InputError.)",
      py::arg("path"), py::kw_only(), py::arg("up") = py::none());
}

void bindArea(py::module_& module) {
  py::class_<Area, Mesh, std::shared_ptr<Area>> area(
      module, "WalkableArea",
      R"(The walkable area of an environment, as `run` and `walkable_area` return it: a `NavigationMesh` that knows what it
was made from, and so can say why a place is walkable or not, and what keeps two places apart. str(area) is a
table of the run for people.)");
  area.def_property_readonly(
          "environment", [](const Area& a) { return held(a.environment); },
          "The `Environment` that the pipeline ran over.")
      .def_property_readonly(
          "pipeline", [](const Area& a) { return a.pipeline; }, "The `Pipeline`.")
      .def_property_readonly(
          "area", [](const Area& a) { return a.result.summary.area; },
          "Of the surface, rounded, in the square of the environment's unit.")
      .def("__str__", [](const Area& a) { return shownText(summaryOf(a)); })
      .def("__repr__",
           [](const Area& a) {
             return shownText("<footfall.WalkableArea of " + a.environment->source + ": " + sizesOf(*a.data) + ">");
           })
      .def(py::pickle(&areaState, &areaFromState));
  define(
      area, "statistics", &statisticsOf,
      R"(Return what each step did and what it took: a dict with the keys of `footfall run --stats`, such as "steps" (a
list of dict, of which "from_cache" says that the step was not computed again), "total_ms", "times", "threads" and, of
parallel blocks, "blocks".)");
  defineSave(area,
             "Write the area as `NavigationMesh.save` does, with the pipeline in the comments: the same bytes as "
             "`footfall run`.",
             [](const Area& a) { return makeExportHeader(a.pipeline); });
}

void bindRunning(py::module_& module) {
  py::class_<ResultCache, std::shared_ptr<ResultCache>> cache(
      module, "ResultCache",
      R"(What runs keep for later ones: with the same cache, a run computes only what its environment or its pipeline
changes. The results are the same.)");
  defineConstructor(
      cache, [](std::size_t capacity, std::size_t bytes) { return std::make_shared<ResultCache>(capacity, bytes); },
      R"(capacity: how many states of runs are kept, one for each step of each run; those used last stay.
bytes: about how much memory they may take; 0: an eighth of the machine's.)",
      py::arg("capacity") = 32, py::arg("bytes") = 0);
  define(
      cache, "clear", [](ResultCache& c) { c.clear(); }, "Forget everything.");

  define(
      module, "run",
      [](std::shared_ptr<Environment> environment, const py::object& pipeline, int threads,
         std::shared_ptr<ResultCache> cache, const py::object& progress) -> py::object {
        if (isAgentList(pipeline)) return runAgentList(environment, pipeline, threads, cache, progress);
        const bool isPipeline = py::isinstance<Pipeline>(pipeline) || py::isinstance<py::sequence>(pipeline);
        const bool isAgent = pipeline.is_none() || py::isinstance<Agent>(pipeline);
        if (!isAgent && !isPipeline)
          throw InputError(
              "pipeline: " + typeNameOf(pipeline) +
              " is not accepted; give a footfall.Pipeline, its text, a list of steps, a footfall.Agent, or "
              "a list of agents");
        Pipeline steps = isAgent ? pipelineFor(*environment, agentFrom(pipeline, {})) : pipelineFrom(pipeline);
        return py::cast(run(std::move(environment), std::move(steps), threads, std::move(cache), progress));
      },
      R"(Run a pipeline over an environment and return a `WalkableArea`; for a list of agents, return a list of areas.

environment: an `Environment`.
pipeline: a `Pipeline`, its text, a list of steps such as ("SlopeFilter", 45), or an `Agent`, for
    Environment.pipeline_for(agent=...); None: Agent(). Or a list of `Agent`: steps that their pipelines share are
    computed once, and each area has the bytes of a run of its own. An empty list is refused.
threads: how many may work, 0: as many as the machine has. The result does not depend on it.
cache: a `ResultCache` that several runs share, or None.
progress: called as progress(step, name, fraction), in the calling thread: a step's number from 0, its filter's
    name, and how much of it is done, 0 to 1. What it raises cancels the run. Steps count from 0 for each agent.

Other Python threads go on meanwhile. Ctrl-C cancels the run and raises KeyboardInterrupt; the cache keeps what
was finished. Raises InputError for a pipeline that is wrong, and RunError.)",
      py::arg("environment").none(false), py::arg("pipeline") = py::none(), py::kw_only(), py::arg("threads") = 0,
      py::arg("cache") = py::none(), py::arg("progress") = py::none());

  define(
      module, "walkable_area",
      [](const py::object& vertices, const py::object& triangles, double slope, double height, double minimumArea,
         double step, double gap, double radius, double drop, const std::string& up, double metresPerUnit,
         bool bothSides, const py::object& obstacleOnly, int threads, const py::object& progress,
         const py::object& agent) {
        const auto environment = environmentFrom(vertices, triangles, {up, metresPerUnit, bothSides, obstacleOnly});
        const Agent walker = agentFrom(agent, {slope, height, minimumArea, step, gap, radius, drop});
        return run(environment, pipelineFor(*environment, walker), threads, nullptr, progress);
      },
      R"(Return where an agent can walk on a triangle soup, exactly: a `WalkableArea`.

    area = footfall.walkable_area(vertices, triangles, slope=45, height=2)
    area.vertices, area.triangles, area.layers   # numpy arrays

vertices: shape (n, 3), float64: x, y and z, finite.
triangles: shape (m, 3), integers: the numbers of three vertices, counter-clockwise seen from the front; only
    front sides can be walked on. They need not be connected, and may cross each other.
slope: degrees, above 0 and below 90: the steepest ground that the agent walks on.
height: metres, above 0: the free height that it needs.
minimum_area: square metres: connected parts that are no larger are left out.
step: metres, at least 0: how high it climbs at once, on stairs and kerbs; 0: it does not lift its feet.
gap: metres, at least 0: how wide a gap it steps over, seen from above.
radius: metres, at least 0: how far its middle stays away from walls and ledges; 0: it is a point.
drop: metres, at least 0: how deep it drops from a ledge, one way; 0: it drops nowhere.
up, metres_per_unit, both_sides, obstacle_only: as for `Environment`.
threads, progress: as for `run`. Ctrl-C raises KeyboardInterrupt within some 50 ms.
agent: an `Agent` in place of slope, height, minimum_area, step, gap, radius and drop, or None.

Raises InputError for arrays or numbers that are wrong, and RunError.)",
      py::arg("vertices"), py::arg("triangles"), py::arg("slope") = 45.0, py::arg("height") = 2.0, py::kw_only(),
      py::arg("minimum_area") = 1.0, py::arg("step") = 0.4, py::arg("gap") = 0.05, py::arg("radius") = 0.0,
      py::arg("drop") = 0.0, py::arg("up") = "z", py::arg("metres_per_unit") = 1.0, py::arg("both_sides") = false,
      py::arg("obstacle_only") = py::none(), py::arg("threads") = 0, py::arg("progress") = py::none(),
      py::arg("agent") = py::none());
}

}  // namespace

std::string sizesOf(const NavigationMesh& mesh) {
  const auto counted = [](std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
  };
  return counted(mesh.vertices.size(), "vertex", "vertices") + ", " +
         counted(mesh.triangles.size(), "triangle", "triangles") + ", " + counted(mesh.layerCount, "layer", "layers");
}

std::string labelOf(const Environment& environment) { return "walkable area of " + environment.source; }

void checkThreads(int threads) {
  constexpr int kMostThreads = 1024;
  if (threads < 0 || threads > kMostThreads)
    throw InputError("threads: " + std::to_string(threads) + " is out of range; give 0 to " +
                     std::to_string(kMostThreads));
}

std::shared_ptr<Area> areaOf(std::shared_ptr<const Environment> environment, AgentRun run,
                             std::shared_ptr<ResultCache> cache) {
  auto area = std::make_shared<Area>();
  area->result = std::move(run.result);
  area->data = area->result.mesh;
  area->label = labelOf(*environment);
  area->agent = describeAgent(run.pipeline);
  area->environment = std::move(environment);
  area->pipeline = std::move(run.pipeline);
  area->cache = std::move(cache);
  return area;
}

std::shared_ptr<Area> run(std::shared_ptr<const Environment> environment, Pipeline pipeline, int threads,
                          std::shared_ptr<ResultCache> cache, const py::object& progress) {
  checkThreads(threads);
  AgentRun made{std::move(pipeline), {}};
  made.result = interruptible(progress, [&](RunContext& context) {
    return runPipeline(environment, made.pipeline, context, cache.get(), threads);
  });
  return areaOf(std::move(environment), std::move(made), std::move(cache));
}

void bindRuns(py::module_& module) {
  bindMesh(module);
  bindArea(module);
  bindRunning(module);
}

}  // namespace footfall::python
