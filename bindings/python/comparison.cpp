// Comparing two meshes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "arrays.hpp"
#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/compare.hpp"
#include "interruptible.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

using SharedComparison = std::shared_ptr<MeshComparison>;

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
          "Of what the other mesh does not cover, heights differing by `Comparison.height` at most.")
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

}  // namespace

void bindComparison(py::module_& module) {
  bindParts(module);
  py::class_<MeshComparison, SharedComparison>(
      module, "Comparison", "How two meshes A and B differ, as exact sets of points and by distances.")
      .def_property_readonly("equal", &MeshComparison::equal,
                             "Whether both are the same set of points, exactly, whatever their triangulation.")
      .def_property_readonly(
          "only_a", [](const MeshComparison& c) { return c.sets.areas[0].surface; },
          "The area of the surface that is in A only; exactly 0.0 only where there is none.")
      .def_property_readonly(
          "only_b", [](const MeshComparison& c) { return c.sets.areas[1].surface; },
          "The area of the surface that is in B only.")
      .def_property_readonly(
          "both", [](const MeshComparison& c) { return c.sets.areas[2].surface; },
          "The area of the surface that is in both.")
      .def_property_readonly("equal_links", &MeshComparison::hasEqualLinks,
                             "Whether both have the same steps, exactly.")
      .def_property_readonly(
          "equal_drops", [](const MeshComparison& c) { return c.equalDrops; },
          "Whether both have the same drops: the same starts and landings, exactly.")
      .def_property_readonly(
          "link_lengths", [](const MeshComparison& c) { return c.links.lengths; },
          "The lengths of steps in the plan, a list of three: of those only in A, only in B, and in both.")
      .def_property_readonly("covered", &MeshComparison::covered,
                             "The share of A that B covers, heights differing by `height` at most: 0 to 1.")
      .def_property_readonly("area_ratio", &MeshComparison::areaRatio, "Area of B over area of A; None for an empty A.")
      .def_property_readonly(
          "height", [](const MeshComparison& c) { return c.height; }, "What `covered` allows.")
      .def_property_readonly(
          "a", [](const MeshComparison& c) { return c.meshes[0].whole; }, "A `ComparedPart`.")
      .def_property_readonly(
          "b", [](const MeshComparison& c) { return c.meshes[1].whole; }, "A `ComparedPart`.")
      .def_property_readonly(
          "layers_a", [](const MeshComparison& c) { return c.meshes[0].layers; },
          "The layers of A: a list of `ComparedPart`.")
      .def_property_readonly(
          "layers_b", [](const MeshComparison& c) { return c.meshes[1].layers; },
          "The layers of B: a list of `ComparedPart`.")
      .def_property_readonly(
          "a_to_b", [](const MeshComparison& c) { return distancesOf(c, 0); },
          "`Distances` from A to B; None where a mesh is empty.")
      .def_property_readonly(
          "b_to_a", [](const MeshComparison& c) { return distancesOf(c, 1); },
          "`Distances` from B to A; None where a mesh is empty.")
      .def("__repr__", [](const MeshComparison& c) {
        return std::string("<footfall.Comparison: ") + (c.equal() ? "equal" : "different") + ">";
      });

  define(
      module, "compare",
      [](const std::shared_ptr<Mesh>& a, const std::shared_ptr<Mesh>& b, std::optional<double> height,
         std::optional<double> error, const py::object& progress) {
        return interruptible(progress, [&](RunContext& context) {
          return std::make_shared<MeshComparison>(compareMeshes(*a->data, *b->data, {height, error}, &context));
        });
      },
      R"(Compare two meshes and return a `Comparison`.

a, b: a `NavigationMesh` each (a `WalkableArea` is one; `read_mesh` reads one), in the same frame and units.
height: how far heights may differ where one still covers the other; None: hardly, 2**-30 of the largest
    coordinate.
error: how close the bounds of `Distances.hausdorff` are to be; None: a thousandth of the diagonal.
progress: as for `run`. Raises InputError for a height or error that is out of range.)",
      py::arg("a"), py::arg("b"), py::kw_only(), py::arg("height") = py::none(), py::arg("error") = py::none(),
      py::arg("progress") = py::none());
}

}  // namespace footfall::python
