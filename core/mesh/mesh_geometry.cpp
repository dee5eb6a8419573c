// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/index_and_box.hpp"
#include "core/exact/face_geometry.hpp"

namespace footfall::detail {

PlanTriangle planTriangleOf(const std::vector<MeshVertex>& vertices, const MeshTriangle& triangle) {
  return planTriangleOf(triangle, [&](Index v) { return planPlaceOf(vertices[v]); });
}

Index MeshGeometry::origin(Index vertex) const { return kernel_.mesh().triangles[vertices_[vertex].face][0]; }

MaybeSign MeshGeometry::filtered(Index a, Index b, Index c) const {
  const MeshVertex &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
  return filteredOrientation({p.x, p.y, p.error}, {q.x, q.y, q.error}, {r.x, r.y, r.error}, kernel_.sign().slack);
}

int MeshGeometry::orientation(Index a, Index b, Index c) {
  if (a == b || b == c || a == c) return 0;
  const Index p = vertices_[a].source, q = vertices_[b].source, r = vertices_[c].source;
  if (p >= 0 && q >= 0 && r >= 0) return kernel_.orientation(p, q, r, fallbacks);
  const MaybeSign sign = filtered(a, b, c);
  return sign ? *sign : doubtfulOrientation(a, b, c);
}

// Decides by what the points are, else by their values.
int MeshGeometry::doubtfulOrientation(Index a, Index b, Index c) {
  const MeshVertex &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
  const auto areOnLineOf = [&](const PlanPoint& x, const PlanPoint& y, const PlanPoint& z) {
    if (x.kind() == PlanPoint::EdgePlane) {
      const PlanLine line = edgeOf(x);
      return isKnownOn(line, x.face(), y) && isKnownOn(line, x.face(), z);
    }
    if (x.kind() != PlanPoint::Crossing) return false;
    const PlanLine first = x.firstLine(), second = x.secondLine();
    return (isKnownOn(first, x.face(), y) && isKnownOn(first, x.face(), z)) ||
           (isKnownOn(second, x.face(), y) && isKnownOn(second, x.face(), z));
  };
  if (areOnLineOf(p.point, q.point, r.point) || areOnLineOf(q.point, r.point, p.point) ||
      areOnLineOf(r.point, p.point, q.point))
    return 0;
  return kernel_.orientation(p.point, q.point, r.point, origin(b), fallbacks);
}

PlanLine MeshGeometry::edgeOf(const PlanPoint& p) const {
  const Index a = kernel_.mesh().planIds[p.edgeBegin()], b = kernel_.mesh().planIds[p.edgeEnd()];
  return {PlanLine::Edge, std::min(a, b), std::max(a, b)};
}

// Traces are the same line only on the same face.
bool MeshGeometry::isKnownOn(const PlanLine& line, Index face, const PlanPoint& p) const {
  if (p.kind() == PlanPoint::Crossing)
    return (line.kind == PlanLine::Edge || p.face() == face) && (p.firstLine() == line || p.secondLine() == line);
  if (line.kind != PlanLine::Edge) return false;
  if (p.kind() == PlanPoint::Source) return p.planId() == line.a || p.planId() == line.b;
  return edgeOf(p) == line;
}

int MeshGeometry::compare(Index a, Index b, int axis) { return compare(vertices_[a], vertices_[b], axis); }

int MeshGeometry::compare(const MeshVertex& p, const MeshVertex& q, int axis) {
  const double u = axis == 0 ? p.x : p.y, v = axis == 0 ? q.x : q.y;
  const double bound = (p.error + q.error + (std::fabs(u) + std::fabs(v)) * 0x1p-52) * kInflate;
  if (u - v > bound) return 1;
  if (u - v < -bound) return -1;
  return kernel_.compare(p.point, q.point, axis, kernel_.mesh().triangles[p.face][0], fallbacks);
}

bool MeshGeometry::isBetween(Index u, Index v, Index w) {
  if (orientation(u, v, w) != 0) return false;
  for (const int axis : {0, 1}) {
    const int first = compare(u, v, axis);
    if (first != 0) return compare(v, w, axis) == first;
  }
  return false;
}

// Two triangles are apart when an edge of one has all corners of the other on its outer side. Doubles are tried on all
// six edges first: only where none of them separates for sure are the doubtful ones decided exactly.
//
// One bound serves all doubles, u = 2^-53: relative to one corner, coordinates are at most d in size, and each is off
// by at most e + u d, e being the vertices' own error. Differences of two are at most 2 d and off by f = 2 e + 4 u d.
// The difference of two products of them is then off by at most 2 (4 d f + f^2 + 4 u d^2) + 8 u d^2 (1 + u), and what
// these roundings themselves lose is covered by 32 in place of 16 and by kInflate. Of source vertices on a grid of few
// bits, all of it is exact.
bool MeshGeometry::overlap(const PlanTriangle& s, const PlanTriangle& t) {
  std::array<std::array<double, 3>, 2> x, y;
  for (int k = 0; k < 3; ++k) {
    x[0][k] = s.x[k] - s.x[0];
    y[0][k] = s.y[k] - s.y[0];
    x[1][k] = t.x[k] - s.x[0];
    y[1][k] = t.y[k] - s.y[0];
  }
  const bool isExact = s.isSource && t.isSource && kernel_.hasExactOrientations();
  double bound = 0;
  if (!isExact) {
    double size = 0;
    for (int m = 0; m < 2; ++m)
      for (int k = 0; k < 3; ++k) size = std::max({size, std::fabs(x[m][k]), std::fabs(y[m][k])});
    const double f = 2 * std::max(s.error, t.error) + 4 * 0x1p-53 * size;
    bound = (8 * size * f + 2 * f * f + 32 * 0x1p-53 * size * size) * kInflate + kernel_.sign().slack;
  }
  std::array<bool, 6> isDoubtful{};
  for (int m = 0; m < 2; ++m) {
    const int n = 1 - m;
    const auto& own = (m == 0 ? s : t).corners;
    const auto& others = (m == 0 ? t : s).corners;
    for (int i = 0; i < 3; ++i) {
      const int j = next(i);
      const double ux = x[m][j] - x[m][i], uy = y[m][j] - y[m][i];
      std::array<double, 3> sides{};
      for (int k = 0; k < 3; ++k) sides[k] = ux * (y[n][k] - y[m][i]) - uy * (x[n][k] - x[m][i]);
      if (std::max({sides[0], sides[1], sides[2]}) > bound) continue;
      // Corners that both have are on the edge.
      const auto isOutside = [&](int k) {
        return sides[k] < -bound || isExact || others[k] == own[i] || others[k] == own[j];
      };
      if (isOutside(0) && isOutside(1) && isOutside(2)) return false;
      isDoubtful[3 * m + i] = true;
    }
  }
  for (int edge = 0; edge < 6; ++edge) {
    if (!isDoubtful[edge]) continue;
    const auto& own = (edge < 3 ? s : t).corners;
    const auto& others = (edge < 3 ? t : s).corners;
    const Index a = own[edge % 3], b = own[(edge + 1) % 3];
    if (std::all_of(others.begin(), others.end(), [&](Index c) { return orientation(a, b, c) <= 0; })) return false;
  }
  return true;
}

}  // namespace footfall::detail
