// Texts of Python that hold names of files, which need not be UTF-8.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace footfall::python {

/// The name of a file as Python has it: os.fsencode() gives the same bytes back.
pybind11::str fileNameOf(const std::string& name);

/// The bytes of a name that Python has. Throws InputError, which begins with `argument`, where there are none.
std::string bytesOfName(const pybind11::str& name, const std::string& argument);

/// A text for people. A byte that is no UTF-8 is shown as \xff.
pybind11::str shownText(const std::string& text);

/// The type of an object with its article, for messages: "an int", "a str".
std::string typeNameOf(const pybind11::handle& object);

}  // namespace footfall::python
