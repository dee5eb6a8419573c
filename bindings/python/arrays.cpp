// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

#include "footfall/errors.hpp"
#include "texts.hpp"

namespace footfall::python {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double) && std::is_trivially_copyable_v<Vec3>);
static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));

std::string shapeOf(const py::array& array) { return py::str(array.attr("shape")); }
std::string typeOf(const py::array& array) { return py::str(array.dtype()); }

/// The array that numpy makes of an object; `wanted` names the expected value in messages.
py::array arrayFrom(const py::object& given, const std::string& name, const char* wanted) {
  const py::array array = given.is_none() ? py::array() : py::array::ensure(given);
  if (!array || given.is_none())
    throw InputError(name + ": " + typeNameOf(given) + " is no array of numbers; give " + wanted);
  return array;
}

/// True when each number of the array is one of the kinds ("f" real, "i" signed, "u" unsigned, "b" truth) and fits into
/// eight bytes.
bool hasNumbers(const py::array& array, std::string_view kinds) {
  return kinds.find(array.dtype().kind()) != std::string_view::npos && array.itemsize() <= 8;
}

void checkRows(const py::array& array, const std::string& name, const char* wanted) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw InputError(name + ": the shape is " + shapeOf(array) + "; give " + wanted);
  if (array.shape(0) == 0) throw InputError(name + ": there are no rows; give one at least");
  if (static_cast<std::size_t>(array.shape(0)) > std::numeric_limits<std::uint32_t>::max())
    throw InputError(name + ": there are more than 4294967295 rows; give fewer");
}

/// `array` as rows of another type, one after the other. A copy only where that is needed.
template <class Number>
py::array_t<Number> rowsOf(const py::array& array) {
  auto rows = py::array_t<Number, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!rows) throw py::error_already_set();
  return rows;
}

/// Copies all numbers of an array of integers; `refuse` gets the place and the text of one that is not below `end`.
template <class Number, class Refuse>
std::vector<std::uint32_t> copyBelow(const py::array& array, std::uint64_t end, const Refuse& refuse) {
  const py::array_t<Number> rows = rowsOf<Number>(array);
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(rows.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Number number = rows.data()[i];
    // A negative number is a huge one without its sign.
    if (static_cast<std::uint64_t>(number) >= end) refuse(i, std::to_string(number));
    numbers[i] = static_cast<std::uint32_t>(number);
  }
  return numbers;
}

template <class Refuse>
std::vector<std::uint32_t> integersBelow(const py::array& array, std::uint64_t end, const Refuse& refuse) {
  if (array.dtype().kind() == 'i') return copyBelow<std::int64_t>(array, end, refuse);
  if (array.itemsize() == 8) return copyBelow<std::uint64_t>(array, end, refuse);
  return copyBelow<std::uint32_t>(array, end, refuse);
}

template <class Element>
py::array view(const Element* elements, const std::vector<py::ssize_t>& shape, const py::capsule& base) {
  py::array array(py::dtype::of<Element>(), shape, elements, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

template <std::size_t N>
py::array rowsView(const std::vector<std::array<std::uint32_t, N>>& rows, const py::capsule& base) {
  return view(rows.empty() ? nullptr : rows.front().data(), {static_cast<py::ssize_t>(rows.size()), N}, base);
}

}  // namespace

std::vector<Vec3> pointsFrom(const py::object& given, const std::string& name) {
  constexpr const char* kWanted = "an array of shape (n, 3) and type float64, x, y and z of each vertex";
  const py::array array = arrayFrom(given, name, kWanted);
  checkRows(array, name, kWanted);
  if (!hasNumbers(array, "fiu")) throw InputError(name + ": the type is " + typeOf(array) + "; give " + kWanted);
  const py::array_t<double> rows = rowsOf<double>(array);
  std::vector<Vec3> points(static_cast<std::size_t>(rows.shape(0)));
  const double* next = rows.data();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {next[0], next[1], next[2]};
    next += 3;
    for (const double coordinate : {points[i].x, points[i].y, points[i].z})
      if (!std::isfinite(coordinate))
        throw InputError(name + "[" + std::to_string(i) + "]: a coordinate is " +
                         std::string(py::str(py::float_(coordinate))) + "; give finite numbers");
  }
  return points;
}

std::vector<Triangle> trianglesFrom(const py::object& given, const std::string& name, std::size_t vertexCount) {
  constexpr const char* kWanted =
      "an array of shape (m, 3) and type uint32, the numbers of each triangle's vertices, counter-clockwise from the "
      "front";
  const py::array array = arrayFrom(given, name, kWanted);
  checkRows(array, name, kWanted);
  if (!hasNumbers(array, "iu")) throw InputError(name + ": the type is " + typeOf(array) + "; give " + kWanted);
  const std::vector<std::uint32_t> corners =
      integersBelow(array, vertexCount, [&](std::size_t at, const std::string& number) {
        throw InputError(name + "[" + std::to_string(at / 3) + "]: there is no vertex " + number +
                         "; give numbers from 0 to " + std::to_string(vertexCount - 1));
      });
  std::vector<Triangle> triangles(corners.size() / 3);
  std::memcpy(triangles.data(), corners.data(), corners.size() * sizeof(std::uint32_t));
  return triangles;
}

TriangleSoup soupFrom(const py::object& vertices, const py::object& triangles) {
  TriangleSoup soup;
  soup.vertices = pointsFrom(vertices, "vertices");
  soup.triangles = trianglesFrom(triangles, "triangles", soup.vertices.size());
  return soup;
}

std::vector<std::uint8_t> flagsFrom(const py::object& given, const std::string& name, std::size_t count) {
  const std::string wanted = "an array of shape (" + std::to_string(count) + ",) and type bool";
  const py::array array = arrayFrom(given, name, wanted.c_str());
  if (array.ndim() != 1 || static_cast<std::size_t>(array.shape(0)) != count)
    throw InputError(name + ": the shape is " + shapeOf(array) + "; give " + wanted);
  if (!hasNumbers(array, "b")) throw InputError(name + ": the type is " + typeOf(array) + "; give " + wanted);
  const py::array_t<bool> rows = rowsOf<bool>(array);
  return {rows.data(), rows.data() + count};
}

std::vector<std::uint32_t> numbersFrom(const py::object& given, const std::string& name, std::size_t count) {
  const std::string wanted = "an array of shape (" + std::to_string(count) + ",) and type uint32";
  const py::array array = arrayFrom(given, name, wanted.c_str());
  if (array.ndim() != 1 || static_cast<std::size_t>(array.shape(0)) != count)
    throw InputError(name + ": the shape is " + shapeOf(array) + "; give " + wanted);
  if (!hasNumbers(array, "iu")) throw InputError(name + ": the type is " + typeOf(array) + "; give " + wanted);
  constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();
  return integersBelow(array, kEnd, [&](std::size_t at, const std::string& number) {
    throw InputError(name + "[" + std::to_string(at) + "]: is " + number + "; give numbers from 0 to " +
                     std::to_string(kEnd - 1));
  });
}

Vec3 pointFrom(const py::object& given, const std::string& name) {
  constexpr const char* kWanted = "three numbers: x, y and z";
  const py::array array = arrayFrom(given, name, kWanted);
  if (array.ndim() != 1 || array.shape(0) != 3 || !hasNumbers(array, "fiu"))
    throw InputError(name + ": an array of shape " + shapeOf(array) + " and type " + typeOf(array) +
                     " is not accepted; give " + kWanted);
  const py::array_t<double> row = rowsOf<double>(array);
  const Vec3 point{row.data()[0], row.data()[1], row.data()[2]};
  if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
    throw InputError(name + ": a coordinate is not finite; give finite numbers");
  return point;
}

py::array arrayOf(const Vec3& point) {
  const std::array<double, 3> row{point.x, point.y, point.z};
  return py::array(py::dtype::of<double>(), std::vector<py::ssize_t>{3}, row.data());
}

py::array viewOf(const std::vector<Vec3>& points, const py::capsule& base) {
  return view(points.empty() ? nullptr : &points.front().x, {static_cast<py::ssize_t>(points.size()), 3}, base);
}

py::array viewOf(const std::vector<Triangle>& triangles, const py::capsule& base) { return rowsView(triangles, base); }

py::array viewOf(const std::vector<std::array<std::uint32_t, 2>>& pairs, const py::capsule& base) {
  return rowsView(pairs, base);
}

py::array viewOf(const std::vector<std::uint32_t>& numbers, const py::capsule& base) {
  return view(numbers.data(), {static_cast<py::ssize_t>(numbers.size())}, base);
}

py::array viewOf(const std::vector<std::uint8_t>& flags, const py::capsule& base) {
  static_assert(sizeof(bool) == 1);
  return view(reinterpret_cast<const bool*>(flags.data()), {static_cast<py::ssize_t>(flags.size())}, base);
}

}  // namespace footfall::python
