// Filters and pipelines.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bindings.hpp"
#include "definitions.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/pipeline.hpp"
#include "texts.hpp"
#include "types.hpp"

namespace footfall::python {
namespace {

std::string_view wordFor(ParameterType type) {
  switch (type) {
    case ParameterType::Real:
      return "float";
    case ParameterType::Integer:
      return "int";
    case ParameterType::Boolean:
      break;
  }
  return "bool";
}

std::string_view wordFor(Unit unit) {
  switch (unit) {
    case Unit::Degrees:
      return "degrees";
    case Unit::Length:
      return "length";
    case Unit::Area:
      return "area";
    case Unit::Count:
      return "count";
    case Unit::None:
      break;
  }
  return "";
}

std::string_view wordFor(FilterKind kind) {
  switch (kind) {
    case FilterKind::Strategy:
      return "strategy";
    case FilterKind::Collapse:
      return "collapse";
    case FilterKind::Filter:
      break;
  }
  return "filter";
}

/// A value of a step as Python has it.
py::object valueOf(ParameterType type, double value) {
  switch (type) {
    case ParameterType::Integer:
      return py::int_(static_cast<long long>(value));
    case ParameterType::Boolean:
      return py::bool_(value != 0);
    case ParameterType::Real:
      break;
  }
  return py::float_(value);
}

py::tuple stepOf(const PipelineStep& step) {
  py::list parts;
  parts.append(std::string(step.filter->name));
  for (std::size_t i = 0; i < step.values.size(); ++i)
    parts.append(valueOf(step.filter->parameterOf(i).type, step.values[i]));
  return py::tuple(parts);
}

/// The line of a step that is a text, or a sequence of a name and values.
std::string lineOf(const py::handle& step) {
  if (py::isinstance<py::str>(step)) return py::str(step);
  if (!py::isinstance<py::sequence>(step))
    throw InputError("pipeline: " + typeNameOf(step) +
                     " is not accepted as a step; give \"SlopeFilter 45\" or (\"SlopeFilter\", 45)");
  std::string line;
  for (const py::handle part : step) {
    if (!line.empty()) line += ' ';
    if (py::isinstance<py::bool_>(part))
      line += py::cast<bool>(part) ? "true" : "false";
    else
      line += py::str(part);
  }
  return line;
}

std::string textOf(const Pipeline& pipeline) { return formatPipeline(pipeline); }

}  // namespace

Pipeline pipelineFrom(const py::object& given) {
  if (py::isinstance<Pipeline>(given)) return py::cast<Pipeline>(given);
  std::string text;
  if (py::isinstance<py::str>(given)) {
    text = py::str(given);
  } else if (py::isinstance<py::sequence>(given)) {
    for (const py::handle step : given) {
      std::string line = lineOf(step);
      std::ranges::replace(line, '\n', ' ');
      text += line + '\n';
    }
  } else {
    throw InputError("pipeline: " + typeNameOf(given) +
                     " is not accepted; give a footfall.Pipeline, its text, or a list of steps");
  }
  return parsePipeline(text, "pipeline");
}

void bindPipelines(py::module_& module) {
  py::class_<ParameterDescriptor> parameter(module, "Parameter",
                                            "What a number of a step means: one of `Filter.parameters`.");
  parameter
      .def_property_readonly(
          "name", [](const ParameterDescriptor& p) { return p.name; }, "Identifier, e.g. \"max_slope\".")
      .def_property_readonly(
          "label", [](const ParameterDescriptor& p) { return p.label; }, "For people.")
      .def_property_readonly(
          "help", [](const ParameterDescriptor& p) { return p.help; }, "One or two sentences.")
      .def_property_readonly(
          "type", [](const ParameterDescriptor& p) { return wordFor(p.type); }, "\"float\", \"int\" or \"bool\".")
      .def_property_readonly(
          "unit", [](const ParameterDescriptor& p) { return wordFor(p.unit); },
          "\"degrees\", \"length\", \"area\", \"count\" or \"\"; lengths and areas are in the "
          "environment's units.")
      .def_property_readonly(
          "default", [](const ParameterDescriptor& p) { return valueOf(p.type, p.defaultValue); },
          "Lengths and areas: in metres.")
      .def_property_readonly(
          "minimum", [](const ParameterDescriptor& p) { return p.minimum; },
          "The least value, which may itself be out of range.")
      .def_property_readonly(
          "maximum", [](const ParameterDescriptor& p) { return p.maximum; },
          "The largest value, which may itself be out of range.")
      .def_property_readonly(
          "optional", [](const ParameterDescriptor& p) { return p.optional; }, "Whether a step may leave it out.")
      .def("__repr__", [](const ParameterDescriptor& p) { return "<footfall.Parameter " + std::string(p.name) + ">"; });

  py::class_<FilterDescriptor> filter(module, "Filter", "What a pipeline can be made of; `filters()` lists them all.");
  filter
      .def_property_readonly(
          "name", [](const FilterDescriptor& f) { return f.name; }, "As in pipelines, e.g. \"SlopeFilter\".")
      .def_property_readonly(
          "aliases", [](const FilterDescriptor& f) { return f.aliases; }, "Other names for it.")
      .def_property_readonly(
          "label", [](const FilterDescriptor& f) { return f.label; }, "For people.")
      .def_property_readonly(
          "help", [](const FilterDescriptor& f) { return f.help; }, "What it does.")
      .def_property_readonly(
          "precondition", [](const FilterDescriptor& f) { return f.precondition; },
          "What must hold before; empty when nothing must.")
      .def_property_readonly(
          "effect", [](const FilterDescriptor& f) { return f.effect; }, "What holds afterwards.")
      .def_property_readonly(
          "source", [](const FilterDescriptor& f) { return f.source; }, "Where the method is from.")
      .def_property_readonly(
          "parameters", [](const FilterDescriptor& f) { return f.parameters; },
          "Its numbers, in order: a list of `Parameter`.")
      .def_property_readonly(
          "repeats", [](const FilterDescriptor& f) { return f.repeats; },
          "So many of the last parameters are a group that a step has any number of times; 0: none.")
      .def_property_readonly(
          "kind", [](const FilterDescriptor& f) { return wordFor(f.kind); },
          "\"filter\", \"strategy\" (begins a parallel block) or \"collapse\" (ends one).")
      .def_property_readonly(
          "is_local", [](const FilterDescriptor& f) { return f.scope == Scope::Local; },
          "Whether it may stand in a parallel block.")
      .def("__repr__", [](const FilterDescriptor& f) { return "<footfall.Filter " + std::string(f.name) + ">"; });

  define(
      module, "filters",
      [] {
        const auto all = filterDescriptors();
        return std::vector<FilterDescriptor>(all.begin(), all.end());
      },
      R"(Return all filters and strategies, a list of `Filter`.

help(footfall) cannot show them all: for f in footfall.filters(): print(f.name, f.help))");

  py::class_<Pipeline> pipeline(module, "Pipeline",
                                R"(An ordered list of filters with their numbers. It never changes.

len(p) counts the steps, p[i] is one as a tuple such as ("SlopeFilter", 45.0), str(p) the text of a pipeline
file. Lengths and areas are in the units of the environment that it runs over.)");
  defineConstructor(
      pipeline, [](const py::object& steps) { return pipelineFrom(steps); },
      R"(Make a pipeline from its text (one filter a line, its numbers behind it, `#` for comments), or from a list of
steps, each "SlopeFilter 45" or ("SlopeFilter", 45). Raises InputError, with the line, for an unknown filter
and for a number that is missing or out of range.)",
      py::arg("steps"));
  pipeline.def("__len__", [](const Pipeline& p) { return p.steps.size(); })
      .def("__getitem__",
           [](const Pipeline& p, py::ssize_t i) {
             const auto count = static_cast<py::ssize_t>(p.steps.size());
             if (i < -count || i >= count)
               throw py::index_error("the pipeline has " + std::to_string(count) + " steps");
             return stepOf(p.steps[static_cast<std::size_t>(i < 0 ? i + count : i)]);
           })
      .def(
          "__eq__", [](const Pipeline& a, const Pipeline& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const Pipeline& p) { return py::hash(py::str(textOf(p))); })
      .def("__str__", &textOf)
      .def("__repr__",
           [](const Pipeline& p) { return "footfall.Pipeline(" + std::string(py::repr(py::str(textOf(p)))) + ")"; })
      .def(py::pickle([](const Pipeline& p) { return py::str(textOf(p)); },
                      [](const py::str& text) { return parsePipeline(std::string(text), "pickle"); }));

  define(
      module, "read_pipeline", [](const std::filesystem::path& path) { return readPipelineFile(path.string()); },
      "Read a pipeline file. Raises InputError.", py::arg("path"));
}

}  // namespace footfall::python
