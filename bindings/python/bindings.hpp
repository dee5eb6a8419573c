// The parts of the module, each in a file of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace footfall::python {

void bindAgents(pybind11::module_& module);
void bindPipelines(pybind11::module_& module);
void bindEnvironments(pybind11::module_& module);
void bindRuns(pybind11::module_& module);
void bindPaths(pybind11::module_& module);
void bindInspection(pybind11::module_& module);
void bindComparison(pybind11::module_& module);
void bindGround(pybind11::module_& module);

}  // namespace footfall::python
