// Paths for an agent with a body in Python.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace footfall::python {

void bindBodyPaths(pybind11::module_& module);

}  // namespace footfall::python
