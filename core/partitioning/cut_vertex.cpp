// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/cut_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/exact/plan_kernel.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

double coordinateOf(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

int compare(double a, double b) { return (a > b) - (a < b); }

// Coordinate `axis` of the place where the edge from `a` to `b` passes through c along `cutAxis`, if wider
// floating-point numbers decide which double is the nearest. Five operations on the step and one on the sum lose at
// most half an epsilon each.
std::optional<double> nearestOnEdge(const Vec3& a, const Vec3& b, int cutAxis, double c, int axis) {
  using Wide = long double;
  const Wide from = coordinateOf(a, axis), start = coordinateOf(a, cutAxis);
  const Wide step = (c - start) * (coordinateOf(b, axis) - from) / (coordinateOf(b, cutAxis) - start);
  const Wide place = from + step;
  const Wide error = (8 * std::fabs(step) + 2 * std::fabs(place)) * std::numeric_limits<Wide>::epsilon();
  const auto low = static_cast<double>(place - error), high = static_cast<double>(place + error);
  if (low != high || std::isinf(low)) return std::nullopt;
  return low;
}

}  // namespace

int CutGeometry::cornerSide(Index u, Index v, Index x, Index y) const {
  const Vec3 &p = mesh_.vertices[u], &q = mesh_.vertices[v];
  return facing({p.x, p.y, 0}, {q.x, q.y, 0}, {border(0, x), border(1, y), 0});
}

CutVertex CutGeometry::edgePoint(Index u, Index v, int axis, Index number) const {
  CutVertex point{CutVertex::OnEdge, std::min(u, v), std::max(u, v)};
  point.borders[static_cast<std::size_t>(axis)] = number;
  const Vec3 &p = mesh_.vertices[point.a], &q = mesh_.vertices[point.b];
  if (axis == 0 || p.x == q.x) return point;
  const auto& xs = borders_[0];  // vertices are sorted by x
  const auto first = std::upper_bound(xs.begin(), xs.end(), p.x), last = std::lower_bound(first, xs.end(), q.x);
  const auto it = std::partition_point(
      first, last, [&](const double& x) { return side(point, 0, static_cast<Index>(&x - xs.data())) > 0; });
  if (it == last || side(point, 0, static_cast<Index>(it - xs.begin())) != 0) return point;
  point.borders = {static_cast<Index>(it - xs.begin()), -1};
  return point;
}

// The other coordinate of the edge (dx, dy), at the border's coordinate c, is off the corner by the corner's
// determinant over dx or dy.
int CutGeometry::side(const CutVertex& vertex, int axis, Index number) const {
  const auto k = static_cast<std::size_t>(axis);
  if (vertex.kind == CutVertex::Source)
    return compare(coordinateOf(mesh_.vertices[vertex.a], axis), border(axis, number));
  if (vertex.borders[k] >= 0) return (vertex.borders[k] > number) - (vertex.borders[k] < number);
  const Vec3 &p = mesh_.vertices[vertex.a], &q = mesh_.vertices[vertex.b];
  if (coordinateOf(p, axis) == coordinateOf(q, axis)) return compare(coordinateOf(p, axis), border(axis, number));
  if (axis == 1) return -cornerSide(vertex.a, vertex.b, vertex.borders[0], number) * compare(q.x, p.x);
  return cornerSide(vertex.a, vertex.b, number, vertex.borders[1]) * compare(q.y, p.y);
}

bool CutGeometry::isBefore(const CutVertex& p, const CutVertex& q) const {
  const Vec3 &from = mesh_.vertices[p.a], &to = mesh_.vertices[p.b];
  const int axis = q.axis();
  const bool rises = coordinateOf(to, axis) > coordinateOf(from, axis);
  return side(p, axis, q.borders[static_cast<std::size_t>(axis)]) == (rises ? -1 : 1);
}

std::array<mpq_class, 3> CutGeometry::exactPlace(const CutVertex& vertex) const {
  const auto exact = [&](Index v) -> std::array<mpq_class, 3> {
    const Vec3& p = mesh_.vertices[v];
    return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
  };
  if (vertex.kind == CutVertex::Source) return exact(vertex.a);
  if (vertex.kind == CutVertex::OnEdge) {
    const int axis = vertex.axis();
    const auto a = exact(vertex.a), b = exact(vertex.b);
    const mpq_class c(border(axis, vertex.borders[static_cast<std::size_t>(axis)]));
    const mpq_class t = (c - a[axis]) / (b[axis] - a[axis]);
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  }
  const auto& f = mesh_.triangles[vertex.a];
  const auto a = exact(f[0]), b = exact(f[1]), c = exact(f[2]);
  const auto normal = [&](int i, int j) -> mpq_class {
    return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  };
  const mpq_class x(border(0, vertex.borders[0])), y(border(1, vertex.borders[1]));
  return {x, y, a[2] - (normal(1, 2) * (x - a[0]) + normal(2, 0) * (y - a[1])) / normal(0, 1)};
}

Vec3 CutGeometry::roundedPlace(const CutVertex& vertex) const {
  if (vertex.kind == CutVertex::Source) return mesh_.vertices[vertex.a];
  std::array<double, 3> place{};
  bool known = true;
  if (vertex.kind == CutVertex::OnEdge) {
    const Vec3 &a = mesh_.vertices[vertex.a], &b = mesh_.vertices[vertex.b];
    const int axis = vertex.axis();
    const double c = border(axis, vertex.borders[static_cast<std::size_t>(axis)]);
    for (int k = 0; k < 3 && known; ++k) {
      const auto nearest = k == axis ? std::optional(c) : nearestOnEdge(a, b, axis, c, k);
      known = nearest.has_value();
      place[static_cast<std::size_t>(k)] = nearest.value_or(0);
    }
  } else {
    const auto& f = mesh_.triangles[vertex.a];
    const double z = mesh_.vertices[f[0]].z;
    known = mesh_.vertices[f[1]].z == z && mesh_.vertices[f[2]].z == z;
    place = {border(0, vertex.borders[0]), border(1, vertex.borders[1]), z};
  }
  if (!known) {
    const auto exact = exactPlace(vertex);
    for (std::size_t k = 0; k < 3; ++k) place[k] = nearestDouble(exact[k]);
  }
  return {place[0] + 0.0, place[1] + 0.0, place[2] + 0.0};
}

}  // namespace footfall::detail
