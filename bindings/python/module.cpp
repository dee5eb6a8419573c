// The module footfall._core; footfall/__init__.py is what users import.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <exception>

#include "bindings.hpp"
#include "body_paths.hpp"
#include "corridors.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"
#include "texts.hpp"

namespace {

/// Sets an error of Python with a message that may hold the name of a file, which need not be UTF-8.
void setError(const char* type, const char* message) {
  const auto text = footfall::python::shownText(message);
  PyErr_SetObject(pybind11::module_::import("footfall._core").attr(type).ptr(), text.ptr());
}

void translate(std::exception_ptr exception) {
  try {
    if (exception) std::rethrow_exception(exception);
  } catch (const footfall::InputError& error) {
    setError("InputError", error.what());
  } catch (const footfall::RunError& error) {
    setError("RunError", error.what());
  }
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  using namespace footfall::python;

  // Docstrings state signatures themselves (definitions.hpp).
  py::options options;
  options.disable_function_signatures();

  auto& input = py::register_exception<footfall::InputError>(module, "InputError", PyExc_ValueError);
  input.doc() = "A file, an array, a pipeline or a parameter is wrong. The message says what, where and what to do.";
  auto& run = py::register_exception<footfall::RunError>(module, "RunError", PyExc_RuntimeError);
  run.doc() = "A result cannot be written, or memory or disk ran out.";

  py::register_exception_translator(&translate);

  bindAgents(module);
  bindPipelines(module);
  bindEnvironments(module);
  bindRuns(module);
  bindPaths(module);
  bindInspection(module);
  bindComparison(module);
  bindGround(module);
  bindCorridors(module);
  bindBodyPaths(module);
  module.attr("__version__") = footfall::version();
}
