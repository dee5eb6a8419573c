// Pickles: what environments, meshes and areas are as tuples of Python, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "footfall/environment.hpp"
#include "footfall/inspect.hpp"
#include "footfall/navigation_mesh.hpp"
#include "types.hpp"

namespace footfall::python {

// Names of files are bytes, and numbers are in the order of bytes of the machine that wrote them (all that Footfall
// runs on have one order). Functions that read throw InputError for what does not fit together, and for another
// version.

py::dict stateOf(const Environment& environment);
std::shared_ptr<Environment> environmentFromState(const py::dict& state);

py::dict stateOf(const NavigationMesh& mesh);
std::shared_ptr<const NavigationMesh> meshFromState(const py::dict& state);

py::tuple stateOf(const Component& component);
Component componentFromState(const py::tuple& state);

/// Makes copy.copy() and copy.deepcopy() return the object itself: a class whose objects never change.
template <class Class>
void defineCopies(Class& type) {
  type.def("__copy__", [](const py::object& self) { return self; });
  type.def("__deepcopy__", [](const py::object& self, const py::object& /*memo*/) { return self; });
}

}  // namespace footfall::python
