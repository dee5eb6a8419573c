// Functions of Python whose docstrings begin with a signature that help() shows and inspect.signature() reads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>

namespace footfall::python {

namespace py = pybind11;

/// Writes "name(self, first, *, second=0)" from the arguments as pybind11 receives them.
class Signature {
 public:
  explicit Signature(const std::string& name) : text_(name + "(") {}

  void add(const py::arg& argument) { append(argument.name); }
  void add(const py::arg_v& argument) {
    append(std::string(argument.name) + "=" + std::string(py::repr(argument.value)));
  }
  void add(const py::kw_only&) { append("*"); }
  void append(const std::string& argument) {
    if (text_.back() != '(') text_ += ", ";
    text_ += argument;
  }
  /// The docstring in the form that Python parses.
  [[nodiscard]] std::string docstring(const char* doc) const { return text_ + ")\n--\n\n" + doc; }

 private:
  std::string text_;
};

template <class... Arguments>
std::string docstring(const char* name, bool isMethod, const char* doc, const Arguments&... arguments) {
  Signature signature(name);
  if (isMethod) signature.append("self");
  (signature.add(arguments), ...);
  return signature.docstring(doc);
}

/// Adds a function to a module; `arguments` are py::arg, with their defaults, and py::kw_only.
template <class Function, class... Arguments>
void define(py::module_& module, const char* name, Function&& function, const char* doc,
            const Arguments&... arguments) {
  module.def(name, std::forward<Function>(function), docstring(name, false, doc, arguments...).c_str(), arguments...);
}

/// The same as a method of a class.
template <class Class, class... Options, class Function, class... Arguments>
void define(py::class_<Class, Options...>& type, const char* name, Function&& function, const char* doc,
            const Arguments&... arguments) {
  type.def(name, std::forward<Function>(function), docstring(name, true, doc, arguments...).c_str(), arguments...);
}

/// The constructor of a class: what `make` returns.
template <class Class, class... Options, class Function, class... Arguments>
void defineConstructor(py::class_<Class, Options...>& type, Function&& make, const char* doc,
                       const Arguments&... arguments) {
  type.def(py::init(std::forward<Function>(make)), docstring("__init__", true, doc, arguments...).c_str(),
           arguments...);
}

}  // namespace footfall::python
