// SPDX-License-Identifier: GPL-3.0-or-later
#include "texts.hpp"

#include "footfall/errors.hpp"

namespace footfall::python {

namespace py = pybind11;

py::str fileNameOf(const std::string& name) {
  PyObject* text = PyUnicode_DecodeFSDefaultAndSize(name.data(), static_cast<Py_ssize_t>(name.size()));
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

std::string bytesOfName(const py::str& name, const std::string& argument) {
  PyObject* bytes = PyUnicode_EncodeFSDefault(name.ptr());
  if (bytes == nullptr) {
    PyErr_Clear();
    throw InputError(argument + ": the text cannot be the name of a file; give other characters");
  }
  return py::reinterpret_steal<py::bytes>(bytes);
}

py::str shownText(const std::string& text) {
  PyObject* shown = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace");
  if (shown == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(shown);
}

std::string typeNameOf(const py::handle& object) {
  const std::string name = py::str(py::type::handle_of(object).attr("__name__"));
  return (name.find_first_of("AEIOUaeiou") == 0 ? "an " : "a ") + name;
}

}  // namespace footfall::python
