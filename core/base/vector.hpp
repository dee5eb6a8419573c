// Vectors of three numbers. Each operation is written once, so that all callers round in the same order.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "footfall/geometry.hpp"

namespace footfall::detail {

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double f, const Vec3& a) { return {f * a.x, f * a.y, f * a.z}; }
inline Vec3 operator*(const Vec3& a, double f) { return f * a; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The length of a vector; the computation overflows only where the length itself does.
inline double length(const Vec3& a) { return std::hypot(a.x, a.y, a.z); }

/// The normal of a triangle, twice the area long. It points up where the corners are counter-clockwise from above.
inline Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }
inline double areaOf(const Vec3& a, const Vec3& b, const Vec3& c) { return length(normalOf(a, b, c)) / 2; }

/// The cross product for any kind of numbers, also exact ones.
template <class T>
std::array<T, 3> operator-(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {T(a[0] - b[0]), T(a[1] - b[1]), T(a[2] - b[2])};
}
template <class T>
std::array<T, 3> operator*(const T& f, const std::array<T, 3>& a) {
  return {T(f * a[0]), T(f * a[1]), T(f * a[2])};
}
template <class T>
T dot(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return T(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}
template <class T>
std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}

}  // namespace footfall::detail
