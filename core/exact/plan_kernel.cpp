// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/plan_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/exact/grid_of_parts.hpp"
#include "core/exact/plan_predicates.hpp"
#include "core/exact/rounded_quotient.hpp"
#include "core/exact/sign_of_area.hpp"

namespace footfall::detail {
namespace {

// An approximation worse than this share of the coordinates (or of one unit of the grid) is computed exactly instead.
// It only decides which of two right ways is taken.
constexpr double kCoarse = 0x1p-26;

// True when nothing underflows in predicates of source vertices, whose degree is three at most: with scaled multiples
// of 2^-200 no product is below 2^-600, and none of a product and a bound of rounding below 2^-660. The rule of the
// kernel is that of the highest degree, and doubts all of them on much coarser grids.
bool isExactBelowProducts(const SignRule& rule, Grid grid, const std::vector<double>& heights) {
  if (rule.zeroValid) return true;
  const int scale = grid.scaleExponent();
  for (const double h : heights) grid.include(h);
  return grid.low + scale >= -200 && grid.top + scale <= 38;
}

bool hasCorners(const SourceMesh& mesh, Index triangle, Index a, Index b) {
  const auto& f = mesh.triangles[triangle];
  return (f[0] == a || f[1] == a || f[2] == a) && (f[0] == b || f[1] == b || f[2] == b);
}

int sgn(__int128 x) { return (x > 0) - (x < 0); }

bool isMadeOfEdges(const PlanPoint& point) {
  return point.kind() != PlanPoint::Crossing ||
         (point.firstLine().kind == PlanLine::Edge && point.secondLine().kind == PlanLine::Edge);
}

template <class Integer>
Homogeneous<Integer> homogeneousOn(const GridContext<Integer>& c, const PlanPoint& point) {
  if constexpr (std::is_same_v<Integer, FixedInteger>) {
    if (c.small && isMadeOfEdges(point)) {
      const GridContext<__int128> few{c.mesh, c.heights, c.borders, c.gridExponent, true, true, c.origin, {}};
      const auto h = homogeneousOn(few, point);
      return {FixedInteger(h[0]), FixedInteger(h[1]), FixedInteger(h[2])};
    }
  }
  auto h = rawHomogeneous(c, point);
  if (sgn(h[2]) < 0)
    for (Integer& x : h) negate(x);
  return h;
}

IntegerView viewOf(const FixedInteger& x) { return x; }
IntegerView viewOf(const mpz_class& x) {
  return {mpz_limbs_read(x.get_mpz_t()), static_cast<int>(mpz_size(x.get_mpz_t())) * sgn(x)};
}

// A border in doubles. The sign rule is that of the mesh and the heights, so borders change no decision without a
// border. The value must therefore keep within the limits for which the rule was proven, whatever the border: a
// multiple of 2^-38, below 2^37 (and a difference to a coordinate below 2^38). Otherwise the error bounds the
// deviation.
ErrorDouble scaledBorder(double coordinate, int scale) {
  const double scaled = std::ldexp(coordinate, scale);
  if (!(std::fabs(scaled) < 0x1p37)) return {0, std::numeric_limits<double>::infinity()};
  const double onGrid = std::nearbyint(scaled * 0x1p38) * 0x1p-38;
  // A scaled coordinate that underflowed becomes 0 here.
  const bool exact = onGrid == scaled && (onGrid != 0 || coordinate == 0);
  return {onGrid, exact ? 0 : 0x1p-38};
}

}  // namespace

PlanKernel::PlanKernel(std::shared_ptr<const SourceMesh> mesh, std::vector<double> heights, BorderCoordinates borders)
    : mesh_(std::move(mesh)), heights_(std::move(heights)), borders_(std::move(borders)), grid_(mesh_->grid) {
  const int scale = mesh_->grid.scaleExponent();
  for (const double h : heights_) {
    grid_.include(h);
    scaledHeights_.push_back(std::ldexp(h, scale));
  }
  sign_ = grid_.signRule(scale);
  exactOrientations_ = mesh_->grid.hasExactOrientations();
  for (const std::size_t axis : {0, 1})
    for (double& c : borders_[axis]) {
      c += 0.0;  // no negative zero, as in the mesh
      grid_.include(c);
      scaledBorders_[axis].push_back(scaledBorder(c, scale));
    }
}

std::optional<Index> PlanKernel::levelOf(double height) const {
  for (std::size_t i = 0; i < heights_.size(); ++i)
    if (heights_[i] == height) return static_cast<Index>(i) + 1;
  return std::nullopt;
}

DoubleContext PlanKernel::doubleContext(Index origin) const { return {*mesh_, scaledHeights_, scaledBorders_, origin}; }

template <class Integer>
GridContext<Integer> PlanKernel::gridContext(Index origin) const {
  const int width = grid_.width();
  return {*mesh_, heights_, borders_, grid_.low, width <= kNarrowGrid, width <= kSmallGrid, origin, {}};
}

template <class Evaluate>
int PlanKernel::exactSign(Index origin, const Evaluate& evaluate) const {
  if (fitsFixedIntegers()) return sgn(evaluate(gridContext<FixedInteger>(origin)));
  return sgn(evaluate(gridContext<mpz_class>(origin)));
}

int PlanKernel::orientationBeyondFilter(Index a, Index b, Index c, ExactFallbacks& count) const {
  const auto& places = mesh_->planIds;
  if (places[a] == places[b] || places[b] == places[c] || places[c] == places[a]) return 0;
  if (isExactBelowProducts(sign_, mesh_->grid, heights_)) {
    const Vec3 &pa = mesh_->scaled[a], &pb = mesh_->scaled[b], &pc = mesh_->scaled[c];
    if (const MaybeSign s = signOfArea({pa.x, pa.y}, {pb.x, pb.y}, {pc.x, pc.y})) return *s;
  }
  ++count.orientation;
  return exactSign(0, [&](const auto& context) { return planArea(context, a, b, c); });
}

bool PlanKernel::coplanar(Index face, Index other, ExactFallbacks& count) const {
  const auto& f = mesh_->triangles[face];
  for (const Index v : mesh_->triangles[other])
    if (v != f[0] && v != f[1] && v != f[2] && heightSign(face, v, 0, count) != 0) return false;
  return true;
}

bool PlanKernel::isKnownOn(const PlanLine& line, Index face, const PlanPoint& p) const {
  if (line.kind == PlanLine::Edge) {
    if (p.kind() == PlanPoint::Source) return p.planId() == line.a || p.planId() == line.b;
    if (p.kind() == PlanPoint::EdgePlane) return edgeLineOf(p) == line;
    if (p.firstLine() == line || p.secondLine() == line) return true;
    // the second of two lines, if any, is a border: the edge may lie along it
    return p.secondLine().kind == PlanLine::Border && isKnownAlong(line, p);
  }
  if (line.kind == PlanLine::Border) return knownCoordinate(p, line.a) == borderCoordinate(line);
  if (p.kind() == PlanPoint::EdgePlane) {
    // an edge of the obstacle at the level, or an edge of the face in the obstacle's lowered plane
    const Index a = p.edgeBegin(), b = p.edgeEnd();
    return (p.triangle() == face && p.level() == line.b && hasCorners(*mesh_, line.a, a, b)) ||
           (p.triangle() == line.a && p.level() == -line.b && hasCorners(*mesh_, face, a, b));
  }
  return p.kind() == PlanPoint::Crossing && p.face() == face && (p.firstLine() == line || p.secondLine() == line);
}

bool PlanKernel::isKnownAlong(const PlanLine& edge, const PlanPoint& p) const {
  for (const int axis : {0, 1}) {
    const double c = coordinate(mesh_->vertices[edge.a], axis);
    if (c == coordinate(mesh_->vertices[edge.b], axis) && knownCoordinate(p, axis) == c) return true;
  }
  return false;
}

PlanLine PlanKernel::edgeLineOf(const PlanPoint& p) const {
  const Index a = mesh_->planIds[p.edgeBegin()], b = mesh_->planIds[p.edgeEnd()];
  return {PlanLine::Edge, std::min(a, b), std::max(a, b)};
}

std::optional<double> PlanKernel::knownCoordinate(const PlanPoint& p, int axis) const {
  const auto at = [&](Index v) { return coordinate(mesh_->vertices[v], axis); };
  if (p.kind() == PlanPoint::Source) return at(p.planId());
  if (p.kind() == PlanPoint::EdgePlane) {
    if (at(p.edgeBegin()) == at(p.edgeEnd())) return at(p.edgeBegin());
    return std::nullopt;
  }
  for (const PlanLine& l : {p.firstLine(), p.secondLine()}) {
    if (l.kind == PlanLine::Edge && at(l.a) == at(l.b)) return at(l.a);
    if (l.kind == PlanLine::Border && l.a == axis) return borderCoordinate(l);
  }
  return std::nullopt;
}

std::optional<int> PlanKernel::compareKnown(const PlanPoint& a, const PlanPoint& b, int axis) const {
  const auto x = knownCoordinate(a, axis);
  if (!x) return std::nullopt;
  const auto y = knownCoordinate(b, axis);
  if (!y) return std::nullopt;
  return (*x > *y) - (*x < *y);
}

std::optional<int> PlanKernel::knownSide(const PlanLine& border, const PlanPoint& point) const {
  const auto x = knownCoordinate(point, border.a);
  if (!x) return std::nullopt;
  const double c = borderCoordinate(border);
  return (*x > c) - (*x < c);
}

bool PlanKernel::areKnownCollinear(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) const {
  for (const int axis : {0, 1}) {
    const auto x = knownCoordinate(a, axis);
    if (x && knownCoordinate(b, axis) == x && knownCoordinate(c, axis) == x) return true;
  }
  for (const auto& [p, q, r] : {std::array{&a, &b, &c}, std::array{&b, &c, &a}, std::array{&c, &a, &b}}) {
    const auto holds = [&, q = q, r = r](const PlanLine& l, Index face) {
      return isKnownOn(l, face, *q) && isKnownOn(l, face, *r);
    };
    if (p->kind() == PlanPoint::EdgePlane && holds(edgeLineOf(*p), -1)) return true;
    if (p->kind() == PlanPoint::Crossing && (holds(p->firstLine(), p->face()) || holds(p->secondLine(), p->face())))
      return true;
  }
  return false;
}

bool PlanKernel::isKnownLevel(const PlanPoint& point, Index f, Index g) const {
  if (isKnownOn({PlanLine::Trace, g, 0}, f, point) || isKnownOn({PlanLine::Trace, f, 0}, g, point)) return true;
  // Both share the edge.
  const auto& corners = mesh_->triangles[f];
  for (int k = 0; k < 3; ++k) {
    const Index u = corners[k], v = corners[k == 2 ? 0 : k + 1];
    const Index a = mesh_->planIds[u], b = mesh_->planIds[v];
    if (hasCorners(*mesh_, g, u, v) && isKnownOn({PlanLine::Edge, std::min(a, b), std::max(a, b)}, -1, point))
      return true;
  }
  return false;
}

Homogeneous<ErrorDouble> PlanKernel::homogeneous(const PlanPoint& point, Index origin) const {
  auto h = rawHomogeneous(doubleContext(origin), point);
  const MaybeSign s = sign_(h[2]);
  if (s == 1) return h;
  if (s == -1) return {-h[0], -h[1], -h[2]};
  const ErrorDouble unknown(0, std::numeric_limits<double>::infinity());
  return {unknown, unknown, ErrorDouble(1, std::numeric_limits<double>::infinity())};
}

Homogeneous<mpz_class> PlanKernel::exactHomogeneous(const PlanPoint& point, Index origin) const {
  const GridOfParts parts(*this, origin, {&point});
  if (!parts.hasFixedPlaces()) return homogeneousOn(gridContext<mpz_class>(origin), point);
  return parts.onWhole(homogeneousOn(parts.context<FixedInteger>(grid_, origin), point), grid_);
}

Homogeneous<FixedInteger> PlanKernel::fixedHomogeneous(const PlanPoint& point, Index origin) const {
  return homogeneousOn(gridContext<FixedInteger>(origin), point);
}

std::array<ErrorDouble, 3> PlanKernel::coefficients(const PlanLine& line, Index face, Index origin) const {
  return lineCoefficients(doubleContext(origin), line, face);
}

std::array<mpz_class, 3> PlanKernel::exactCoefficients(const PlanLine& line, Index face, Index origin) const {
  return lineCoefficients(gridContext<mpz_class>(origin), line, face);
}

std::array<FixedInteger, 3> PlanKernel::fixedCoefficients(const PlanLine& line, Index face, Index origin) const {
  return lineCoefficients(gridContext<FixedInteger>(origin), line, face);
}

ApproximatePoint PlanKernel::approximateSource(Index planId, Index origin) const {
  const DoubleContext context = doubleContext(origin);
  const ErrorDouble x = context.local(planId, 0), y = context.local(planId, 1);
  return {x.value, y.value, std::max(x.error, y.error) + sign_.slack};
}

namespace {

constexpr double kU = 0x1p-53;

/// A double and a bound of its error.
struct Bounded {
  double value, error;
};

// n . (v - a) - level * height * nz with each product off by at most 2.01 u, each of three sums by u, and the normal by
// its own error; 9 u covers the rounding of the bound.
Bounded quickHeight(const SourceMesh& mesh, const std::vector<double>& scaledHeights, Index t, Index v, Index level) {
  const auto& n = mesh.normals[t];
  const Vec3 &p = mesh.scaled[v], &a = mesh.scaled[mesh.triangles[t][0]];
  const double dx = p.x - a.x, dy = p.y - a.y, dz = p.z - a.z;
  const double h = level == 0 ? 0 : level > 0 ? scaledHeights[level - 1] : -scaledHeights[-level - 1];
  const double tx = n[0].value * dx, ty = n[1].value * dy, tz = n[2].value * dz, th = n[2].value * h;
  const double error =
      ((std::fabs(tx) + std::fabs(ty) + std::fabs(tz) + std::fabs(th)) * (9 * kU) + n[0].error * std::fabs(dx) +
       n[1].error * std::fabs(dy) + n[2].error * (std::fabs(dz) + std::fabs(h))) *
      kInflate;
  return {tx + ty + tz - th, error};
}

// ax by - ay bx of differences of coordinates, as in PlanKernel::orientation.
Bounded quickCross(double ax, double ay, double bx, double by) {
  const double left = ax * by, right = ay * bx;
  return {left - right, (std::fabs(left) + std::fabs(right)) * (6 * kU)};
}

}  // namespace

int PlanKernel::heightSign(Index face, Index vertex, Index level, ExactFallbacks& count) const {
  const bool isExact = isExactBelowProducts(sign_, mesh_->grid, heights_);
  if (isExact) {
    const Bounded quick = quickHeight(*mesh_, scaledHeights_, face, vertex, level);
    if (std::fabs(quick.value) > quick.error) return quick.value > 0 ? 1 : -1;
  }
  const SignRule rule = isExact ? SignRule{0, true} : sign_;
  if (const MaybeSign s = rule(heightValue(doubleContext(0), face, vertex, level))) return *s;
  ++count.height;
  return exactSign(0, [&](const auto& c) { return heightValue(c, face, vertex, level); });
}

// The point divides the segment from a to b as t = N / D. With N' and D' off by at most eN and eD,
// |N'/D' - N/D| = |N'(D - D') + (N' - N) D'| / |D D'| <= (|t'| eD + eN) / (|D'| - eD). The coordinate a + t (b - a)
// then adds u for each of its operations. Nothing underflows while the sign rule holds zeros valid.
std::optional<ApproximatePoint> PlanKernel::approximateQuickly(const PlanPoint& point, Index origin) const {
  if (!sign_.zeroValid) return std::nullopt;
  const auto& scaled = mesh_->scaled;
  Bounded n{}, d{};
  Index a = -1, b = -1;
  if (point.kind() == PlanPoint::EdgePlane) {
    a = point.edgeBegin(), b = point.edgeEnd();
    n = quickHeight(*mesh_, scaledHeights_, point.triangle(), a, point.level());
    const Bounded end = quickHeight(*mesh_, scaledHeights_, point.triangle(), b, point.level());
    d.value = n.value - end.value;
    d.error = n.error + end.error + std::fabs(d.value) * kU;
  } else if (point.kind() == PlanPoint::Crossing && point.firstLine().kind == PlanLine::Edge &&
             point.secondLine().kind == PlanLine::Edge) {
    const PlanLine first = point.firstLine(), second = point.secondLine();
    a = first.a, b = first.b;
    const Vec3 &p = scaled[a], &q = scaled[b], &r = scaled[second.a], &s = scaled[second.b];
    n = quickCross(r.x - p.x, r.y - p.y, s.x - r.x, s.y - r.y);
    d = quickCross(q.x - p.x, q.y - p.y, s.x - r.x, s.y - r.y);
  } else {
    return std::nullopt;
  }
  const double smallest = std::fabs(d.value) * (1 - 4 * kU) - d.error * kInflate;
  if (!(smallest > 0)) return std::nullopt;
  const double t = n.value / d.value;
  const double errorOfT = ((std::fabs(t) * d.error + n.error) / smallest + std::fabs(t) * (2 * kU)) * kInflate;
  const Vec3 &from = scaled[a], &to = scaled[b], &zero = scaled[origin];
  ApproximatePoint result;
  const auto coordinateAt = [&](double start, double end, double base) {
    const double span = end - start, offset = start - base, step = t * span, x = offset + step;
    const double error =
        (std::fabs(span) * errorOfT + std::fabs(step) * (4 * kU) + (std::fabs(offset) + std::fabs(x)) * (2 * kU)) *
        kInflate;
    result.error = std::max(result.error, error);
    return x;
  };
  result.x = coordinateAt(from.x, to.x, zero.x);
  result.y = coordinateAt(from.y, to.y, zero.y);
  if (!(result.error < kCoarse * (std::fabs(result.x) + std::fabs(result.y) + 1))) return std::nullopt;
  result.error += sign_.slack;
  return result;
}

ApproximatePoint PlanKernel::approximate(const Homogeneous<ErrorDouble>& h, const PlanPoint& point,
                                         Index origin) const {
  if (point.kind() == PlanPoint::Source) return approximateSource(point.planId(), origin);
  const ErrorDouble x = h[0] / h[2];
  const ErrorDouble y = h[1] / h[2];
  const double error = std::max(x.error, y.error);
  const double size = std::fabs(x.value) + std::fabs(y.value) + 1;
  if (error < kCoarse * size) return {x.value, y.value, error + sign_.slack};
  const GridOfParts parts(*this, origin, {&point});
  const auto round = [&](const auto& context) -> ApproximatePoint {
    const auto exact = homogeneousOn(context, point);
    const int scale = context.gridExponent + mesh_->grid.scaleExponent();
    const double ex = roundedQuotient(viewOf(exact[0]), viewOf(exact[2]), scale);
    const double ey = roundedQuotient(viewOf(exact[1]), viewOf(exact[2]), scale);
    // Half a unit in the last place, doubled; an underflow is within the slack.
    return {ex, ey, std::max(std::fabs(ex), std::fabs(ey)) * 0x1p-52 + sign_.slack};
  };
  return parts.hasFixedPlaces() ? round(parts.context<FixedInteger>(grid_, origin))
                                : round(parts.context<mpz_class>(grid_, origin));
}

int PlanKernel::orientation(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, Index origin,
                            ExactFallbacks& count) const {
  if (a == b || b == c || a == c) return 0;
  if (a.kind() == PlanPoint::Source && b.kind() == PlanPoint::Source && c.kind() == PlanPoint::Source)
    return orientation(a.planId(), b.planId(), c.planId(), count);
  if (areKnownCollinear(a, b, c)) return 0;
  if (const MaybeSign s =
          sign_(determinant<ErrorDouble>(homogeneous(a, origin), homogeneous(b, origin), homogeneous(c, origin))))
    return *s;
  ++count.orientation;
  const auto evaluate = [&](const auto& context) {
    using T = typename std::decay_t<decltype(context)>::T;
    return determinant<T>(homogeneousOn(context, a), homogeneousOn(context, b), homogeneousOn(context, c));
  };
  if (!fitsFixedIntegers())
    if (const auto s = GridOfParts(*this, origin, {&a, &b, &c}).sign(grid_, origin, evaluate)) return *s;
  return exactSign(origin, evaluate);
}

int PlanKernel::compare(const PlanPoint& a, const PlanPoint& b, int axis, Index origin, ExactFallbacks& count) const {
  if (a == b) return 0;
  if (const auto known = compareKnown(a, b, axis)) return *known;
  if (const MaybeSign s =
          sign_(coordinateDifference<ErrorDouble>(homogeneous(a, origin), homogeneous(b, origin), axis)))
    return *s;
  ++count.order;
  return exactSign(origin, [&](const auto& context) {
    using T = typename std::decay_t<decltype(context)>::T;
    return coordinateDifference<T>(homogeneousOn(context, a), homogeneousOn(context, b), axis);
  });
}

int PlanKernel::compareHeight(const PlanPoint& point, Index f, Index g, ExactFallbacks& count) const {
  if (f == g || isKnownLevel(point, f, g)) return 0;
  const Index origin = mesh_->triangles[f][0];
  const int flip = mesh_->facing[f] * mesh_->facing[g];
  if (const MaybeSign s = sign_(heightDifference(doubleContext(origin), homogeneous(point, origin), f, g)))
    return *s * flip;
  ++count.height;
  return flip * exactSign(origin, [&](const auto& context) {
           return heightDifference(context, homogeneousOn(context, point), f, g);
         });
}

int PlanKernel::side(const PlanLine& line, Index face, const PlanPoint& point, Index origin,
                     ExactFallbacks& count) const {
  if (line.kind == PlanLine::Border) {
    if (const auto known = knownSide(line, point)) return *known;
  } else if (isKnownOn(line, face, point)) {
    return 0;
  }
  if (const MaybeSign s = sign_(lineAtPoint<ErrorDouble>(coefficients(line, face, origin), homogeneous(point, origin))))
    return *s;
  ++count.side;
  return exactSign(origin, [&](const auto& context) {
    using T = typename std::decay_t<decltype(context)>::T;
    return lineAtPoint<T>(lineCoefficients(context, line, face), homogeneousOn(context, point));
  });
}

std::array<mpq_class, 3> PlanKernel::exactPosition(const PlanPoint& point, Index face) const {
  const Index origin = mesh_->triangles[face][0];
  const auto h = exactHomogeneous(point, origin);
  const auto n = gridContext<mpz_class>(origin).normal(face);
  mpq_class x(h[0], h[2]);
  mpq_class y(h[1], h[2]);
  x.canonicalize();
  y.canonicalize();
  // relative to the origin, which lies on the face: nx x + ny y + nz z = 0
  mpq_class z = -(n[0] * x + n[1] * y) / n[2];
  const Vec3& o = mesh_->vertices[origin];
  std::array<mpq_class, 3> result{x, y, z};
  const std::array<double, 3> base{o.x, o.y, o.z};
  for (int k = 0; k < 3; ++k) {
    if (grid_.low >= 0)
      mpq_mul_2exp(result[k].get_mpq_t(), result[k].get_mpq_t(), static_cast<mp_bitcnt_t>(grid_.low));
    else
      mpq_div_2exp(result[k].get_mpq_t(), result[k].get_mpq_t(), static_cast<mp_bitcnt_t>(-grid_.low));
    result[k] += mpq_class(base[k]);
  }
  return result;
}

Vec3 PlanKernel::roundedPosition(const PlanPoint& point, Index face, bool* exact) const {
  if (exact != nullptr) *exact = true;
  const auto& corners = mesh_->triangles[face];
  const Index origin = corners[0];
  const Vec3& o = mesh_->vertices[origin];
  if (point.kind() == PlanPoint::Source)
    for (const Index corner : corners)
      if (mesh_->planIds[corner] == point.planId()) return mesh_->vertices[corner];
  const auto x = knownCoordinate(point, 0), y = knownCoordinate(point, 1);
  const bool isLevel = mesh_->vertices[corners[1]].z == o.z && mesh_->vertices[corners[2]].z == o.z;
  if (x && y && isLevel) return {*x, *y, o.z};
  if (const auto place = placeByTwofolds(point, face, {x, y}, isLevel)) {
    if (exact != nullptr) *exact = false;
    return *place;
  }
  GridOfParts parts(*this);
  parts.addTriangle(face);
  parts.addPoint(point);
  const auto place = [&](const auto& context) -> Vec3 {
    using T = typename std::decay_t<decltype(context)>::T;
    const int low = context.gridExponent;
    const auto h = homogeneousOn(context, point);
    const auto& n = context.normal(face);
    // (local + base) on the grid over a common denominator, without reducing fractions
    const auto round = [&](const T& numerator, const T& denominator, double base) {
      const T whole = numerator + gridInteger<T>(base, low) * denominator;
      return roundedQuotient(viewOf(whole), viewOf(denominator), low, exact);
    };
    const T fall = n[0] * h[0] + n[1] * h[1];
    return {x ? *x : round(h[0], h[2], o.x), y ? *y : round(h[1], h[2], o.y),
            sgn(fall) == 0 ? o.z : round(-fall, n[2] * h[2], o.z)};
  };
  return parts.hasFixedPlaces() ? place(parts.context<FixedInteger>(grid_, origin))
                                : place(parts.context<mpz_class>(grid_, origin));
}

double nearestDouble(const mpq_class& value) {
  return roundedQuotient(viewOf(value.get_num()), viewOf(value.get_den()), 0);
}

}  // namespace footfall::detail
