// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/face_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/exact/filtered_turn.hpp"
#include "core/exact/plan_predicates.hpp"

namespace footfall::detail {

MaybeSign filteredOrientation(const ApproximatePoint& a, const ApproximatePoint& b, const ApproximatePoint& c,
                              double slack) {
  return filteredTurn({a.x - c.x, a.y - c.y}, a.error + c.error, {b.x - c.x, b.y - c.y}, b.error + c.error, slack);
}

// filteredOrientation()'s bound with the largest size and error in the place of all. Differences of two coordinates
// are at most twice as large as the largest; 2^-40 covers the roundings.
void FaceGeometry::place(const ApproximatePoint& point) {
  approximate_.push_back(point);
  const double size = std::max(std::fabs(point.x), std::fabs(point.y));
  if (size <= size_ && point.error <= error_) return;
  size_ = std::max(size_, size);
  error_ = std::max(error_, point.error);
  const double s = 2 * size_, e = 2 * error_;
  surely_ = (4 * s * e + 2 * e * e + 2 * s * s * (9 * 0x1p-53)) * (1 + 0x1p-40) + kernel_.sign().slack;
}

void FaceGeometry::start(Index face) {
  face_ = face;
  const SourceMesh& mesh = kernel_.mesh();
  const auto& corners = mesh.triangles[face];
  origin_ = corners[0];
  points_.clear();
  lines_.clear();
  approximate_.clear();
  places_.clear();
  lineValues_.clear();
  exact_.clear();
  size_ = error_ = 0;
  surely_ = kernel_.sign().slack;
  if (sourceCount_ < mesh.vertices.size() || ++filling_ == 0) forgetSources();
  for (int k = 0; k < 3; ++k) {
    const Index p = sourcePoint(mesh.planIds[corners[k]]);
    addBorder(p, static_cast<std::uint8_t>((1 << k) | (1 << ((k + 2) % 3))));
  }
  for (int k = 0; k < 3; ++k) {
    const Index a = mesh.planIds[corners[k]];
    const Index b = mesh.planIds[corners[(k + 1) % 3]];
    edgeLine(a, b);
    edgeDirection_[k] = a < b ? 1 : -1;
  }
}

void FaceGeometry::forgetSources() {
  sourceCount_ = kernel_.mesh().vertices.size();
  sources_.reset(static_cast<SourceSlot*>(std::calloc(sourceCount_, sizeof(SourceSlot))));
  if (!sources_) throw std::bad_alloc();
  filling_ = 1;
}

Index FaceGeometry::sourcePoint(Index planId) {
  SourceSlot& slot = sources_[planId];
  if (slot.filling == filling_) return slot.point;
  slot = {filling_, points_.append(PlanPoint::source(planId))};
  places_.emplace_back();
  place(kernel_.approximateSource(planId, origin_));
  return slot.point;
}

Index FaceGeometry::point(const PlanPoint& p) {
  if (p.kind() == PlanPoint::Source) return sourcePoint(p.planId());
  const auto [id, isNew] = points_.insert(p);
  if (isNew) {
    places_.emplace_back();
    if (const auto quick = kernel_.approximateQuickly(p, origin_))
      place(*quick);
    else
      place(kernel_.approximate(homogeneous(id), p, origin_));
  }
  return id;
}

Index FaceGeometry::line(const PlanLine& l) {
  const auto [id, isNew] = lines_.insert(l);
  if (isNew) lineValues_.emplace_back();
  return id;
}

Index FaceGeometry::newLine(const PlanLine& l) {
  for (Index k = 0; k < 3; ++k)
    if (lines_[k] == l) return k;
  lineValues_.emplace_back();
  return lines_.append(l);
}

Index FaceGeometry::edgeLine(Index planA, Index planB) {
  return line({PlanLine::Edge, std::min(planA, planB), std::max(planA, planB)});
}

Index FaceGeometry::crossing(Index line1, Index line2) {
  PlanLine l = lines_[line1];
  PlanLine m = lines_[line2];
  if (l.kind == PlanLine::Edge && m.kind == PlanLine::Edge) {
    if (l.a == m.a || l.a == m.b) return sourcePoint(l.a);
    if (l.b == m.a || l.b == m.b) return sourcePoint(l.b);
    if (m.a < l.a || (m.a == l.a && m.b < l.b)) std::swap(l, m);
    return point(PlanPoint::crossing(l, m, -1));
  }
  if (l.kind == PlanLine::Border || m.kind == PlanLine::Border) return borderCrossing(l, m);
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
    if (const auto [u, v] = edgeOf(face_); u >= 0) return point(PlanPoint::edgePlane(u, v, m.a, -m.b));
    if (const auto [u, v] = edgeOf(m.a); u >= 0) return point(PlanPoint::edgePlane(u, v, face_, m.b));
  } else if (m.a < l.a || (m.a == l.a && m.b < l.b)) {
    std::swap(l, m);
  }
  return point(PlanPoint::crossing(l, m, face_));
}

// A crossing without a trace is the same on every face.
Index FaceGeometry::borderCrossing(PlanLine l, PlanLine m) {
  if (m.kind != PlanLine::Border || (l.kind == PlanLine::Border && m.a < l.a)) std::swap(l, m);
  if (l.kind == PlanLine::Edge) {
    const double c = kernel_.borderCoordinate(m);
    for (const Index end : {l.a, l.b})
      if (coordinate(kernel_.mesh().vertices[end], m.a) == c) return sourcePoint(end);
  }
  return point(PlanPoint::crossing(l, m, l.kind == PlanLine::Trace ? face_ : -1));
}

const Homogeneous<ErrorDouble>& FaceGeometry::homogeneous(Index point) {
  Place& place = places_[point];
  if (!place.hasHomogeneous) {
    place.homogeneous = kernel_.homogeneous(points_[point], origin_);
    place.hasHomogeneous = true;
  }
  return place.homogeneous;
}

Index FaceGeometry::exact(Index point) {
  Index& number = places_[point].exact;
  if (number < 0)
    number = kernel_.fitsFixedIntegers() ? exact_.add(kernel_.fixedHomogeneous(points_[point], origin_))
                                         : exact_.add(kernel_.exactHomogeneous(points_[point], origin_));
  return number;
}

Index FaceGeometry::exactLine(Index line) {
  Index& number = lineValues_[line].exact;
  if (number < 0)
    number = kernel_.fitsFixedIntegers() ? exact_.add(kernel_.fixedCoefficients(lines_[line], face_, origin_))
                                         : exact_.add(kernel_.exactCoefficients(lines_[line], face_, origin_));
  return number;
}

int FaceGeometry::side(Index line, Index point) {
  Line& values = lineValues_[line];
  if (!values.hasCoefficients) {
    values.coefficients = kernel_.coefficients(lines_[line], face_, origin_);
    values.hasCoefficients = true;
  }
  const auto& [a, b, c] = values.coefficients;
  const ApproximatePoint& p = approximate_[point];
  const double ax = a.value * p.x, by = b.value * p.y;
  const double value = ax + by + c.value;
  const double bound =
      ((std::fabs(a.value) + std::fabs(b.value) + a.error + b.error) * p.error + a.error * std::fabs(p.x) +
       b.error * std::fabs(p.y) + c.error + (std::fabs(ax) + std::fabs(by) + std::fabs(c.value)) * (5 * 0x1p-53)) *
          kInflate +
      kernel_.sign().slack;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  if (lines_[line].kind == PlanLine::Border) {
    if (const auto known = kernel_.knownSide(lines_[line], points_[point])) return *known;
  } else if (kernel_.isKnownOn(lines_[line], face_, points_[point])) {
    return 0;
  }
  if (const MaybeSign s = kernel_.sign()(lineAtPoint<ErrorDouble>(values.coefficients, homogeneous(point)))) return *s;
  ++fallbacks.side;
  const Index l = exactLine(line), h = exact(point);
  if (kernel_.fitsFixedIntegers()) return sgn(lineAtPoint<FixedInteger>(exact_[l], exact_[h]));
  return sgn(lineAtPoint<mpz_class>(exact_.wide(l), exact_.wide(h)));
}

int FaceGeometry::sideNearby(Index line, Index point) {
  if (lines_[line].kind != PlanLine::Border && kernel_.isKnownOn(lines_[line], face_, points_[point])) return 0;
  return side(line, point);
}

int FaceGeometry::sideOfEdge(int k, Index point) {
  if ((places_[point].border >> k & 1) != 0) return 0;
  const int s = side(k, point) * edgeDirection_[k];
  if (s == 0) addBorder(point, static_cast<std::uint8_t>(1 << k));
  return s;
}

bool FaceGeometry::areOnSameBorder(Index a, Index b, Index c) const {
  return (places_[a].border & places_[b].border & places_[c].border) != 0;
}

int FaceGeometry::orientationBeyondBound(Index a, Index b, Index c) {
  if (a == b || b == c || a == c || areOnSameBorder(a, b, c)) return 0;
  if (kernel_.hasExactOrientations() && isSource(a) && isSource(b) && isSource(c))
    return kernel_.orientation(points_[a].planId(), points_[b].planId(), points_[c].planId(), fallbacks);
  const MaybeSign filtered =
      filteredOrientation(approximate_[a], approximate_[b], approximate_[c], kernel_.sign().slack);
  if (filtered) return *filtered;
  if (kernel_.areKnownCollinear(points_[a], points_[b], points_[c])) return 0;
  if (const MaybeSign s = kernel_.sign()(determinant<ErrorDouble>(homogeneous(a), homogeneous(b), homogeneous(c))))
    return *s;
  ++fallbacks.orientation;
  const Index x = exact(a), y = exact(b), z = exact(c);
  if (kernel_.fitsFixedIntegers()) return sgn(determinant<FixedInteger>(exact_[x], exact_[y], exact_[z]));
  return sgn(determinant<mpz_class>(exact_.wide(x), exact_.wide(y), exact_.wide(z)));
}

int FaceGeometry::compare(Index a, Index b, int axis) {
  if (a == b) return 0;
  const ApproximatePoint &p = approximate_[a], &q = approximate_[b];
  const double u = axis == 0 ? p.x : p.y, v = axis == 0 ? q.x : q.y;
  const double bound =
      (p.error + q.error + 2 * 0x1p-53 * (std::fabs(u) + std::fabs(v))) * kInflate + kernel_.sign().slack;
  if (u - v > bound) return 1;
  if (u - v < -bound) return -1;
  if (const auto known = kernel_.compareKnown(points_[a], points_[b], axis)) return *known;
  if (const MaybeSign s = kernel_.sign()(coordinateDifference<ErrorDouble>(homogeneous(a), homogeneous(b), axis)))
    return *s;
  ++fallbacks.order;
  const Index x = exact(a), y = exact(b);
  if (kernel_.fitsFixedIntegers()) return sgn(coordinateDifference<FixedInteger>(exact_[x], exact_[y], axis));
  return sgn(coordinateDifference<mpz_class>(exact_.wide(x), exact_.wide(y), axis));
}

}  // namespace footfall::detail
