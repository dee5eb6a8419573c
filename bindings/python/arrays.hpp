// numpy arrays in and out: rows of coordinates and of vertex numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "footfall/geometry.hpp"

namespace footfall::python {

namespace py = pybind11;

/// Copies an array of shape (n, 3) of real numbers, or what numpy makes one of. Throws InputError, which begins with
/// `name`, for another shape, another type, no rows, or a coordinate that is not finite.
std::vector<Vec3> pointsFrom(const py::object& given, const std::string& name);

/// Copies an array of shape (m, 3) of integers. Throws InputError as above, and for a number that is not that of one of
/// `vertexCount` vertices.
std::vector<Triangle> trianglesFrom(const py::object& given, const std::string& name, std::size_t vertexCount);

/// Both of the above, as "vertices" and "triangles".
TriangleSoup soupFrom(const py::object& vertices, const py::object& triangles);

/// Copies an array of shape (m,) of truth values. Throws InputError for another shape or type.
std::vector<std::uint8_t> flagsFrom(const py::object& given, const std::string& name, std::size_t count);

/// Copies an array of shape (count,) of integers from 0 to 2^32 - 2. Throws InputError for others.
std::vector<std::uint32_t> numbersFrom(const py::object& given, const std::string& name, std::size_t count);

/// The point of three finite numbers. Throws InputError.
Vec3 pointFrom(const py::object& given, const std::string& name);

/// A new array of shape (3,).
py::array arrayOf(const Vec3& point);

/// Keeps `owner` alive for as long as an array that has this as its base.
template <class Owner>
py::capsule baseOf(std::shared_ptr<const Owner> owner) {
  using Held = std::shared_ptr<const Owner>;
  auto held = std::make_unique<Held>(std::move(owner));
  py::capsule base(held.get(), [](void* pointer) { delete static_cast<Held*>(pointer); });
  held.release();
  return base;
}

// Arrays that show what `base` keeps alive, without a copy and not to be written to.

/// A view of shape (n, 3), float64.
py::array viewOf(const std::vector<Vec3>& points, const py::capsule& base);
/// A view of shape (m, 3), uint32.
py::array viewOf(const std::vector<Triangle>& triangles, const py::capsule& base);
/// A view of shape (k, 2), uint32.
py::array viewOf(const std::vector<std::array<std::uint32_t, 2>>& pairs, const py::capsule& base);
/// A view of shape (m,), uint32.
py::array viewOf(const std::vector<std::uint32_t>& numbers, const py::capsule& base);
/// A view of shape (m,), bool.
py::array viewOf(const std::vector<std::uint8_t>& flags, const py::capsule& base);

}  // namespace footfall::python
