// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/face_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace footfall {

int filteredOrientation(const ApproximatePoint& a, const ApproximatePoint& b, const ApproximatePoint& c, double slack) {
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const double left = ax * by, right = ay * bx;
  const double value = left - right;
  const double errorA = a.error + c.error, errorB = b.error + c.error;
  // First the coordinates' own errors, then 4 u (|l| + |r|) for the arithmetic (differences, products, sum); the factor
  // 9 and kInflate cover the rounding of the bound itself.
  const double bound = ((std::fabs(ax) + std::fabs(ay)) * errorB + (std::fabs(bx) + std::fabs(by)) * errorA +
                        2 * errorA * errorB + (std::fabs(left) + std::fabs(right)) * (9 * 0x1p-53)) *
                           kInflate +
                       slack;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return kUnknownSign;
}

void FaceGeometry::start(Index face) {
  face_ = face;
  const SourceMesh& mesh = kernel_.mesh();
  const auto& corners = mesh.triangles[face];
  origin_ = corners[0];
  points_.clear();
  lines_.clear();
  homogeneous_.clear();
  approximate_.clear();
  border_.clear();
  approximateLines_.clear();
  coefficients_.clear();
  exactPoints_.clear();
  exactLines_.clear();
  for (int k = 0; k < 3; ++k) {
    const Index p = point({PlanPoint::Source, mesh.planIds[corners[k]]});
    addBorder(p, static_cast<std::uint8_t>((1 << k) | (1 << ((k + 2) % 3))));
  }
  for (int k = 0; k < 3; ++k) {
    const Index a = mesh.planIds[corners[k]];
    const Index b = mesh.planIds[corners[(k + 1) % 3]];
    edgeLine(a, b);
    edgeDirection_[k] = a < b ? 1 : -1;
  }
}

Index FaceGeometry::point(const PlanPoint& p) {
  const auto [id, isNew] = points_.insert(p);
  if (isNew) {
    homogeneous_.push_back(kernel_.homogeneous(p, origin_));
    approximate_.push_back(kernel_.approximate(homogeneous_.back(), p, origin_));
    border_.push_back(0);
  }
  return id;
}

Index FaceGeometry::line(const PlanLine& l) {
  const auto [id, isNew] = lines_.insert(l);
  if (isNew) {
    coefficients_.emplace_back();
    approximateLines_.emplace_back();
  }
  return id;
}

Index FaceGeometry::edgeLine(Index planA, Index planB) {
  return line({PlanLine::Edge, std::min(planA, planB), std::max(planA, planB)});
}

bool FaceGeometry::isCornerOf(Index triangle, Index vertex) const {
  const auto& f = kernel_.mesh().triangles[triangle];
  return f[0] == vertex || f[1] == vertex || f[2] == vertex;
}

bool FaceGeometry::isKnownOn(const PlanLine& line, const PlanPoint& p) const {
  const auto& planIds = kernel_.mesh().planIds;
  if (line.kind == PlanLine::Edge) {
    if (p.kind == PlanPoint::Source) return p.a == line.a || p.a == line.b;
    if (p.kind == PlanPoint::EdgePlane) {
      const Index a = planIds[p.a], b = planIds[p.b];
      return std::min(a, b) == line.a && std::max(a, b) == line.b;
    }
    return p.firstLine() == line || p.secondLine() == line;
  }
  if (p.kind == PlanPoint::EdgePlane) {
    // an edge of the obstacle at the level, or an edge of this face in the obstacle's lowered plane
    if (p.c == face_ && p.d == line.b) return isCornerOf(line.a, p.a) && isCornerOf(line.a, p.b);
    return p.c == line.a && p.d == -line.b && isCornerOf(face_, p.a) && isCornerOf(face_, p.b);
  }
  return p.kind == PlanPoint::Crossing && (p.firstLine() == line || p.secondLine() == line);
}

Index FaceGeometry::crossing(Index line1, Index line2) {
  PlanLine l = lines_[line1];
  PlanLine m = lines_[line2];
  if (l.kind == PlanLine::Edge && m.kind == PlanLine::Edge) {
    if (l.a == m.a || l.a == m.b) return point({PlanPoint::Source, l.a});
    if (l.b == m.a || l.b == m.b) return point({PlanPoint::Source, l.b});
    if (m.a < l.a || (m.a == l.a && m.b < l.b)) std::swap(l, m);
    return point({PlanPoint::Crossing, l.kind, l.a, l.b, m.kind, m.a, m.b, -1});
  }
  if (l.kind == PlanLine::Trace) std::swap(l, m);
  if (l.kind == PlanLine::Edge) {
    const SourceMesh& mesh = kernel_.mesh();
    // The same point has the same form on both faces of a shared edge, and on the obstacle itself.
    const auto edgeOf = [&](Index triangle) -> std::pair<Index, Index> {
      const auto& f = mesh.triangles[triangle];
      for (int k = 0; k < 3; ++k) {
        const Index u = f[k], v = f[(k + 1) % 3];
        const Index pu = mesh.planIds[u], pv = mesh.planIds[v];
        if (std::min(pu, pv) == l.a && std::max(pu, pv) == l.b) return {std::min(u, v), std::max(u, v)};
      }
      return {-1, -1};
    };
    if (const auto [u, v] = edgeOf(face_); u >= 0) return point({PlanPoint::EdgePlane, u, v, m.a, -m.b});
    if (const auto [u, v] = edgeOf(m.a); u >= 0) return point({PlanPoint::EdgePlane, u, v, face_, m.b});
  } else if (m.a < l.a || (m.a == l.a && m.b < l.b)) {
    std::swap(l, m);
  }
  return point({PlanPoint::Crossing, l.kind, l.a, l.b, m.kind, m.a, m.b, face_});
}

const Homogeneous<mpz_class>& FaceGeometry::exact(Index point) {
  auto [it, isNew] = exactPoints_.try_emplace(point);
  if (isNew) it->second = kernel_.exactHomogeneous(points_[point], origin_);
  return it->second;
}

const std::array<mpz_class, 3>& FaceGeometry::exactLine(Index line) {
  auto [it, isNew] = exactLines_.try_emplace(line);
  if (isNew) it->second = kernel_.exactCoefficients(lines_[line], face_, origin_);
  return it->second;
}

int FaceGeometry::side(Index line, Index point) {
  ApproximateLine& l = approximateLines_[line];
  if (l.errorA < 0) {
    const auto c = kernel_.coefficients(lines_[line], face_, origin_);
    coefficients_[line] = c;
    l = {c[0].value, c[1].value, c[2].value, c[0].error, c[1].error, c[2].error};
  }
  const ApproximatePoint& p = approximate_[point];
  const double ax = l.a * p.x, by = l.b * p.y;
  const double value = ax + by + l.c;
  const double bound =
      ((std::fabs(l.a) + std::fabs(l.b) + l.errorA + l.errorB) * p.error + l.errorA * std::fabs(p.x) +
       l.errorB * std::fabs(p.y) + l.errorC + (std::fabs(ax) + std::fabs(by) + std::fabs(l.c)) * (5 * 0x1p-53)) *
          kInflate +
      kernel_.sign().slack;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  if (isKnownOn(lines_[line], points_[point])) return 0;
  const auto& h = homogeneous_[point];
  const auto& c = coefficients_[line];
  const int s = kernel_.sign()(c[0] * h[0] + c[1] * h[1] + c[2] * h[2]);
  if (s != kUnknownSign) return s;
  ++fallbacks.side;
  const auto& eh = exact(point);
  const auto& el = exactLine(line);
  const mpz_class exactValue = el[0] * eh[0] + el[1] * eh[1] + el[2] * eh[2];
  return sgn(exactValue);
}

int FaceGeometry::sideOfEdge(int k, Index point) {
  if ((border_[point] >> k & 1) != 0) return 0;
  const int s = side(k, point) * edgeDirection_[k];
  if (s == 0) border_[point] |= static_cast<std::uint8_t>(1 << k);
  return s;
}

int FaceGeometry::orientation(Index a, Index b, Index c) {
  if (a == b || b == c || a == c) return 0;
  const int filtered = filteredOrientation(approximate_[a], approximate_[b], approximate_[c], kernel_.sign().slack);
  if (filtered != kUnknownSign) return filtered;
  if ((border_[a] & border_[b] & border_[c]) != 0) return 0;
  for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
    if (points_[p].kind != PlanPoint::Crossing) continue;
    for (const PlanLine& l : {points_[p].firstLine(), points_[p].secondLine()})
      if (isKnownOn(l, points_[q]) && isKnownOn(l, points_[r])) return 0;
  }
  const auto determinant = [](const auto& x, const auto& y, const auto& z) -> std::decay_t<decltype(x[0])> {
    return x[0] * (y[1] * z[2] - z[1] * y[2]) - x[1] * (y[0] * z[2] - z[0] * y[2]) + x[2] * (y[0] * z[1] - z[0] * y[1]);
  };
  const int s = kernel_.sign()(determinant(homogeneous_[a], homogeneous_[b], homogeneous_[c]));
  if (s != kUnknownSign) return s;
  ++fallbacks.orientation;
  exact(a), exact(b), exact(c);  // references stay valid: nodes of an unordered_map do not move
  const mpz_class value = determinant(exact(a), exact(b), exact(c));
  return sgn(value);
}

int FaceGeometry::compare(Index a, Index b, int axis) {
  if (a == b) return 0;
  const ApproximatePoint &p = approximate_[a], &q = approximate_[b];
  const double u = axis == 0 ? p.x : p.y, v = axis == 0 ? q.x : q.y;
  const double bound =
      (p.error + q.error + 2 * 0x1p-53 * (std::fabs(u) + std::fabs(v))) * kInflate + kernel_.sign().slack;
  if (u - v > bound) return 1;
  if (u - v < -bound) return -1;
  const auto &x = homogeneous_[a], &y = homogeneous_[b];
  const int s = kernel_.sign()(x[axis] * y[2] - y[axis] * x[2]);
  if (s != kUnknownSign) return s;
  ++fallbacks.order;
  const auto& ea = exact(a);
  const auto& eb = exact(b);
  const mpz_class difference = ea[axis] * eb[2] - eb[axis] * ea[2];
  return sgn(difference);
}

}  // namespace footfall
