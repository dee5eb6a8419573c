// The formulas of the predicates in the plan, each written once for all kinds of numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A context supplies the numbers: differences of coordinates, heights and normals, as doubles with a running error
// (DoubleContext) or as integers on the common grid (GridContext).
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "core/base/vector.hpp"
#include "core/exact/fixed_integer.hpp"
#include "core/exact/grid_integer.hpp"
#include "core/exact/plan_kernel.hpp"

namespace footfall::detail {

inline double coordinate(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

struct DoubleContext {
  using T = ErrorDouble;
  const SourceMesh& mesh;
  const std::vector<double>& scaledHeights;
  const std::array<std::vector<ErrorDouble>, 2>& scaledBorders;
  Index origin;

  T difference(Index a, Index b, int axis) const {
    return T(coordinate(mesh.scaled[a], axis)) - T(coordinate(mesh.scaled[b], axis));
  }
  T local(Index v, int axis) const { return difference(v, origin, axis); }
  T height(Index level) const { return level > 0 ? T(scaledHeights[level - 1]) : T(-scaledHeights[-level - 1]); }
  T localBorder(const PlanLine& border) const {
    return scaledBorders[border.a][border.b] - T(coordinate(mesh.scaled[origin], border.a));
  }
  T one() const { return 1.0; }
  const std::array<T, 3>& normal(Index t) const { return mesh.normals[t]; }
};

/// The last two normals that were computed: lines on one face share its normal.
template <class T>
class LatestNormals {
 public:
  /// The reference stays valid until two further normals are computed.
  template <class Context>
  const std::array<T, 3>& of(const Context& c, Index t) {
    if (normals_[latest_].triangle != t && normals_[latest_ ^= 1].triangle != t) normals_[latest_] = {t, compute(c, t)};
    return normals_[latest_].normal;
  }

 private:
  template <class Context>
  static std::array<T, 3> compute(const Context& c, Index t) {
    const auto& f = c.mesh.triangles[t];
    const std::array<T, 3> u{c.difference(f[1], f[0], 0), c.difference(f[1], f[0], 1), c.difference(f[1], f[0], 2)};
    const std::array<T, 3> v{c.difference(f[2], f[0], 0), c.difference(f[2], f[0], 1), c.difference(f[2], f[0], 2)};
    return cross(u, v);
  }

  struct Normal {
    Index triangle = -1;
    std::array<T, 3> normal;
  };
  std::array<Normal, 2> normals_{};
  int latest_ = 0;
};

/// Integer is FixedInteger where the grid is narrow enough for it, else mpz_class. Single points fit __int128 on grids
/// of few bits (kSmallGrid).
template <class Integer>
struct GridContext {
  using T = Integer;
  const SourceMesh& mesh;
  const std::vector<double>& heights;
  const BorderCoordinates& borders;
  int gridExponent;
  bool narrow;  ///< Grid::width() <= kNarrowGrid
  bool small;   ///< Grid::width() <= kSmallGrid
  Index origin;

  T difference(Index a, Index b, int axis) const {
    return gridDifference<T>(coordinate(mesh.vertices[a], axis), coordinate(mesh.vertices[b], axis), gridExponent,
                             narrow);
  }
  T local(Index v, int axis) const { return difference(v, origin, axis); }
  T height(Index level) const {
    return gridInteger<T>(level > 0 ? heights[level - 1] : -heights[-level - 1], gridExponent);
  }
  T localBorder(const PlanLine& border) const {
    return gridDifference<T>(borders[border.a][border.b], coordinate(mesh.vertices[origin], border.a), gridExponent,
                             narrow);
  }
  T one() const { return T(1); }
  const std::array<T, 3>& normal(Index t) const { return normals.of(*this, t); }

  mutable LatestNormals<T> normals{};
};

/// Up to this Grid::width() __int128 holds the coordinates of points that are made without traces: they have 4 D + 4
/// bits, D being the width and one (fixed_integer.hpp).
inline constexpr int kSmallGrid = 29;

inline void negate(ErrorDouble& x) { x.value = -x.value; }
inline void negate(FixedInteger& x) { x.negate(); }
inline void negate(__int128& x) { x = -x; }
inline void negate(mpz_class& x) { mpz_neg(x.get_mpz_t(), x.get_mpz_t()); }

/// Twice the area in the plan of three source vertices.
template <class C>
typename C::T planArea(const C& c, Index p, Index q, Index r) {
  return c.difference(p, r, 0) * c.difference(q, r, 1) - c.difference(p, r, 1) * c.difference(q, r, 0);
}

/// n_t . (v - a_t) - level * height * nz_t: for a face that faces up, the sign of v's height above plane + level.
template <class C>
typename C::T heightValue(const C& c, Index t, Index v, Index level) {
  using T = typename C::T;
  const auto& n = c.normal(t);
  const Index a = c.mesh.triangles[t][0];
  const T height = n[0] * c.difference(v, a, 0) + n[1] * c.difference(v, a, 1) + n[2] * c.difference(v, a, 2);
  if (level == 0) return height;
  return height - n[2] * c.height(level);
}

/// (a, b, c) of a line: a x + b y + c is positive on its left.
template <class C>
std::array<typename C::T, 3> lineCoefficients(const C& c, const PlanLine& line, Index face) {
  using T = typename C::T;
  if (line.kind == PlanLine::Edge) {
    std::array<T, 3> r{c.difference(line.a, line.b, 1), c.difference(line.b, line.a, 0), T()};
    r[2] = -(r[0] * c.local(line.a, 0) + r[1] * c.local(line.a, 1));
    return r;
  }
  if (line.kind == PlanLine::Border) {
    std::array<T, 3> r{T(), T(), -c.localBorder(line)};
    r[line.a] = c.one();
    return r;
  }
  const auto& n = c.normal(line.a);
  const auto& m = c.normal(face);
  const Index a = c.mesh.triangles[line.a][0];
  const Index b = c.mesh.triangles[face][0];
  const T obstacle = n[0] * c.local(a, 0) + n[1] * c.local(a, 1) + n[2] * c.local(a, 2);
  const T floor = m[0] * c.local(b, 0) + m[1] * c.local(b, 1) + m[2] * c.local(b, 2);
  std::array<T, 3> r{T(n[2] * m[0] - m[2] * n[0]), T(n[2] * m[1] - m[2] * n[1]), T(m[2] * obstacle - n[2] * floor)};
  if (line.b != 0) r[2] = r[2] - n[2] * m[2] * c.height(line.b);
  if (c.mesh.facing[line.a] < 0)
    for (T& x : r) negate(x);
  return r;
}

/// Homogeneous coordinates of a point, with w of either sign.
template <class C>
Homogeneous<typename C::T> rawHomogeneous(const C& c, const PlanPoint& p) {
  using T = typename C::T;
  if (p.kind() == PlanPoint::Source) return {c.local(p.planId(), 0), c.local(p.planId(), 1), c.one()};
  if (p.kind() == PlanPoint::EdgePlane) {
    const Index a = p.edgeBegin(), b = p.edgeEnd();
    const T ha = heightValue(c, p.triangle(), a, p.level());
    const T hb = heightValue(c, p.triangle(), b, p.level());
    return {T(c.local(a, 0) * hb - c.local(b, 0) * ha), T(c.local(a, 1) * hb - c.local(b, 1) * ha), T(hb - ha)};
  }
  const auto l = lineCoefficients(c, p.firstLine(), p.face());
  const auto m = lineCoefficients(c, p.secondLine(), p.face());
  return {T(l[1] * m[2] - m[1] * l[2]), T(l[2] * m[0] - m[2] * l[0]), T(l[0] * m[1] - m[0] * l[1])};
}

/// Orientation of three homogeneous points; V is T or a view of one.
template <class T, class V>
T determinant(const std::array<V, 3>& a, const std::array<V, 3>& b, const std::array<V, 3>& c) {
  return a[0] * (b[1] * c[2] - c[1] * b[2]) - a[1] * (b[0] * c[2] - c[0] * b[2]) + a[2] * (b[0] * c[1] - c[0] * b[1]);
}

/// A line at a point, times w.
template <class T, class V>
T lineAtPoint(const std::array<V, 3>& line, const std::array<V, 3>& h) {
  return line[0] * h[0] + line[1] * h[1] + line[2] * h[2];
}

/// Coordinate `axis` of a minus that of b, times both w.
template <class T, class V>
T coordinateDifference(const std::array<V, 3>& a, const std::array<V, 3>& b, int axis) {
  return a[axis] * b[2] - b[axis] * a[2];
}

/// Height of plane f minus height of plane g at a point, times w and both nz.
template <class C>
typename C::T heightDifference(const C& c, const Homogeneous<typename C::T>& h, Index f, Index g) {
  using T = typename C::T;
  const auto& n = c.normal(f);
  const auto& m = c.normal(g);
  const Index a = c.mesh.triangles[f][0];
  const Index b = c.mesh.triangles[g][0];
  const T df = n[0] * c.local(a, 0) + n[1] * c.local(a, 1) + n[2] * c.local(a, 2);
  const T dg = m[0] * c.local(b, 0) + m[1] * c.local(b, 1) + m[2] * c.local(b, 2);
  const T zf = df * h[2] - n[0] * h[0] - n[1] * h[1];  // times 1 / (n_z w)
  const T zg = dg * h[2] - m[0] * h[0] - m[1] * h[1];  // times 1 / (m_z w)
  return zf * m[2] - zg * n[2];
}

}  // namespace footfall::detail
