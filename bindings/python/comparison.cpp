// Comparing two meshes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "arrays.hpp"
#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/compare.hpp"
#include "interruptible.hpp"
#include "texts.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

/// A comparison, and what was compared.
struct ComparedMeshes {
  MeshComparison result;
  std::array<std::string, 2> labels;
};

/// The words for two meshes; areas of one environment are told apart by their agents.
std::array<std::string, 2> labelsOf(const Mesh& a, const Mesh& b) {
  if (a.label != b.label || a.agent == b.agent) return {a.label, b.label};
  const auto labelWithAgent = [](const Mesh& mesh) {
    return mesh.label + (mesh.agent.empty() ? "" : " (" + mesh.agent + ")");
  };
  return {labelWithAgent(a), labelWithAgent(b)};
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string verdictOf(const MeshComparison& c) {
  if (c.equal()) return "Equal: both are the same set of points, exactly.";
  if (!c.sets.hasArea[0]) return "Different: B holds all of A, exactly, and more.";
  if (!c.sets.hasArea[1]) return "Different: A holds all of B, exactly, and more.";
  return "Different as exact sets: neither holds the other.";
}

/// A report for people.
std::string textOf(const ComparedMeshes& compared) {
  const MeshComparison& c = compared.result;
  std::string text;
  for (const std::size_t i : {0, 1}) {
    const MeshPart& whole = c.meshes[i].whole;
    text += std::string(i == 0 ? "A: " : "B: ") + compared.labels[i] + ": " + std::to_string(whole.triangles) +
            " triangles, area " + number(whole.areas.surface) + "\n";
  }
  text += verdictOf(c) + "\n";
  text += "exact: area in A only " + number(c.sets.areas[0].surface) + ", in B only " +
          number(c.sets.areas[1].surface) + ", in both " + number(c.sets.areas[2].surface) + "\n";
  text += "heights within " + number(c.height) + ": area of A that B does not cover " +
          number(c.meshes[0].whole.uncovered.surface) + ", of B that A does not cover " +
          number(c.meshes[1].whole.uncovered.surface) + "\n";
  if (c.distances)
    text += "distance: no point of A is farther than " + number((*c.distances)[0].upper) +
            " from B, none of B farther than " + number((*c.distances)[1].upper) + " from A\n";
  if (!c.hasEqualLinks() || !c.equalDrops)
    text += std::string("links: ") + (c.hasEqualLinks() ? "the same steps and gaps" : "other steps or gaps") + ", " +
            (c.equalDrops ? "the same drops" : "other drops") + "\n";
  text.pop_back();
  return text;
}

/// The same as before under an older name, which could be mistaken for what is uncovered within a height.
template <std::size_t Part>
double olderArea(const ComparedMeshes& c, const char* older, const char* newer) {
  const std::string text = std::string("Comparison.") + older + " is the area in exact sets; use Comparison." + newer;
  if (PyErr_WarnEx(PyExc_DeprecationWarning, text.c_str(), 1) != 0) throw py::error_already_set();
  return c.result.sets.areas[Part].surface;
}

/// One of the two meshes of a comparison, or one of its layers.
void bindParts(py::module_& module) {
  py::class_<MeshPart>(module, "ComparedPart",
                       "A mesh of a comparison, or one of its layers. Areas are in the square of the meshes' unit.")
      .def_property_readonly(
          "name", [](const MeshPart& p) { return p.name; }, "Of the layer; empty for all of it.")
      .def_property_readonly(
          "triangles", [](const MeshPart& p) { return p.triangles; }, "How many.")
      .def_property_readonly(
          "components", [](const MeshPart& p) { return p.components; }, "How many connected parts.")
      .def_property_readonly(
          "area", [](const MeshPart& p) { return p.areas.surface; }, "Of the surface.")
      .def_property_readonly(
          "plan_area", [](const MeshPart& p) { return p.areas.plan; }, "Seen from above.")
      .def_property_readonly(
          "uncovered_area", [](const MeshPart& p) { return p.uncovered.surface; },
          R"(The area of this part over or under which the other mesh has nothing within `Comparison.height`. It is about 0
where this part lies inside the other mesh, however large that is.)")
      .def_property_readonly(
          "uncovered_plan_area", [](const MeshPart& p) { return p.uncovered.plan; }, "The same seen from above.")
      .def("__repr__", [](const MeshPart& p) {
        return "<footfall.ComparedPart " + p.name + (p.name.empty() ? "" : " ") + std::to_string(p.triangles) +
               " triangles, area " + std::string(py::str(py::float_(p.areas.surface))) + ">";
      });

  py::class_<SurfaceDistances>(module, "Distances", "How far the points of one mesh are from another one.")
      .def_property_readonly(
          "samples", [](const SurfaceDistances& d) { return d.samples; }, "How many: one at each position of a corner.")
      .def_property_readonly(
          "max", [](const SurfaceDistances& d) { return d.max; }, "Of the samples.")
      .def_property_readonly(
          "mean", [](const SurfaceDistances& d) { return d.mean; }, "Of the samples.")
      .def_property_readonly(
          "rms", [](const SurfaceDistances& d) { return d.rms; }, "Root of the mean square.")
      .def_property_readonly(
          "farthest", [](const SurfaceDistances& d) { return arrayOf(d.farthest); },
          "Shape (3,): a sample whose distance is `max`.")
      .def_property_readonly(
          "hausdorff", [](const SurfaceDistances& d) { return py::make_tuple(d.lower, d.upper); },
          "(lower, upper): the one-sided Hausdorff distance, over all points, lies between these.")
      .def("__repr__", [](const SurfaceDistances& d) {
        return "<footfall.Distances: max " + std::string(py::str(py::float_(d.max))) + ">";
      });
}

py::object distancesOf(const MeshComparison& comparison, std::size_t from) {
  if (!comparison.distances) return py::none();
  return py::cast((*comparison.distances)[from]);
}

void bindFigures(py::class_<ComparedMeshes, std::shared_ptr<ComparedMeshes>>& type) {
  using C = const ComparedMeshes&;
  type.def_property_readonly(
          "equal", [](C c) { return c.result.equal(); },
          "Whether both are the same set of points, exactly, whatever their triangulation.")
      .def_property_readonly(
          "exact_only_a", [](C c) { return c.result.sets.areas[0].surface; },
          R"(The area of the surface of A of which no point is on B, exactly; 0.0 only where there is none. Rounding moves
sloped ground into another plane, so two results of one level can differ here by all their sloped ground; `uncovered_a`
is what B lacks as people see it.)")
      .def_property_readonly(
          "exact_only_b", [](C c) { return c.result.sets.areas[1].surface; },
          "The area of the surface of B of which no point is on A, exactly.")
      .def_property_readonly(
          "exact_both", [](C c) { return c.result.sets.areas[2].surface; },
          "The area of the surface that is on both, exactly.")
      .def_property_readonly(
          "uncovered_a", [](C c) { return c.result.meshes[0].whole.uncovered.surface; },
          "The area of A over or under which B has nothing within `height`.")
      .def_property_readonly(
          "uncovered_b", [](C c) { return c.result.meshes[1].whole.uncovered.surface; },
          "The area of B over or under which A has nothing within `height`.")
      .def_property_readonly(
          "only_a", [](C c) { return olderArea<0>(c, "only_a", "exact_only_a"); }, "The older name of `exact_only_a`.")
      .def_property_readonly(
          "only_b", [](C c) { return olderArea<1>(c, "only_b", "exact_only_b"); }, "The older name of `exact_only_b`.")
      .def_property_readonly(
          "both", [](C c) { return olderArea<2>(c, "both", "exact_both"); }, "The older name of `exact_both`.")
      .def_property_readonly(
          "equal_links", [](C c) { return c.result.hasEqualLinks(); }, "Whether both have the same steps, exactly.")
      .def_property_readonly(
          "equal_drops", [](C c) { return c.result.equalDrops; },
          "Whether both have the same drops: the same starts and landings, exactly.")
      .def_property_readonly(
          "link_lengths", [](C c) { return c.result.links.lengths; },
          "The lengths of steps in the plan, a list of three: of those only in A, only in B, and in both.")
      .def_property_readonly(
          "covered", [](C c) { return c.result.covered(); },
          "The share of A that B covers, heights differing by `height` at most: 0 to 1. It is 1 where B holds more.")
      .def_property_readonly(
          "area_ratio", [](C c) { return c.result.areaRatio(); }, "Area of B over area of A; None for an empty A.")
      .def_property_readonly(
          "height", [](C c) { return c.result.height; },
          "How far heights may differ for `covered`, `uncovered_a` and `uncovered_b`.");
}

}  // namespace

void bindComparison(py::module_& module) {
  bindParts(module);
  using C = const ComparedMeshes&;
  py::class_<ComparedMeshes, std::shared_ptr<ComparedMeshes>> type(
      module, "Comparison",
      R"(How two meshes A and B differ. str(comparison) is a report for people.

Three measures stand side by side. As exact sets of points in space: `equal`, `exact_only_a`, `exact_only_b`,
`exact_both`. Seen from above, with heights that may differ by `height`: `uncovered_a`, `uncovered_b`, `covered`. By
distances: `a_to_b`, `b_to_a`.)");
  bindFigures(type);
  type.def_property_readonly(
          "a", [](C c) { return c.result.meshes[0].whole; }, "A `ComparedPart`.")
      .def_property_readonly(
          "b", [](C c) { return c.result.meshes[1].whole; }, "A `ComparedPart`.")
      .def_property_readonly(
          "layers_a", [](C c) { return c.result.meshes[0].layers; }, "The layers of A: a list of `ComparedPart`.")
      .def_property_readonly(
          "layers_b", [](C c) { return c.result.meshes[1].layers; }, "The layers of B: a list of `ComparedPart`.")
      .def_property_readonly(
          "a_to_b", [](C c) { return distancesOf(c.result, 0); },
          "`Distances` from A to B; None where a mesh is empty.")
      .def_property_readonly(
          "b_to_a", [](C c) { return distancesOf(c.result, 1); },
          "`Distances` from B to A; None where a mesh is empty.")
      .def("__str__", [](C c) { return shownText(textOf(c)); })
      .def("__repr__", [](C c) {
        return shownText("<footfall.Comparison of " + c.labels[0] + " with " + c.labels[1] + ": " +
                         (c.result.equal() ? "equal" : "different") + ">");
      });

  define(
      module, "compare",
      [](const std::shared_ptr<Mesh>& a, const std::shared_ptr<Mesh>& b, std::optional<double> height,
         std::optional<double> error, const py::object& progress) {
        return interruptible(progress, [&](RunContext& context) {
          return std::make_shared<ComparedMeshes>(
              ComparedMeshes{compareMeshes(*a->data, *b->data, {height, error}, &context), labelsOf(*a, *b)});
        });
      },
      R"(Compare two meshes and return a `Comparison`.

a, b: a `NavigationMesh` each (a `WalkableArea` is one; `read_mesh` reads one), in the same frame and units.
height: how far heights may differ where one still covers the other; None: hardly, 2**-30 of the largest
    coordinate.
error: how close the bounds of `Distances.hausdorff` are to be; None: a thousandth of the diagonal.
progress: as for `run`. Raises InputError for a height or error that is out of range.)",
      py::arg("a").none(false), py::arg("b").none(false), py::kw_only(), py::arg("height") = py::none(),
      py::arg("error") = py::none(), py::arg("progress") = py::none());
}

}  // namespace footfall::python
