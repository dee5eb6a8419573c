// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/plan_kernel.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall {
namespace {

// An approximation worse than this share of the coordinates (or of one unit of the grid) is computed exactly instead.
// It only decides which of two right ways is taken.
constexpr double kCoarse = 0x1p-26;

double coordinate(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

mpz_class toInteger(double x, int gridExponent) {
  if (x == 0) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  mpz_class result = std::ldexp(mantissa, 53);
  const int shift = exponent - 53 - gridExponent;
  if (shift >= 0)
    mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
  else
    mpz_tdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
  return result;
}

// The arithmetic of a predicate is written once, over a context that supplies differences of coordinates.
struct DoubleContext {
  using T = ErrorDouble;
  const SourceMesh& mesh;
  const std::vector<double>& scaledHeights;
  Index origin;

  T difference(Index a, Index b, int axis) const {
    return T(coordinate(mesh.scaled[a], axis)) - T(coordinate(mesh.scaled[b], axis));
  }
  T local(Index v, int axis) const { return difference(v, origin, axis); }
  T height(Index level) const { return level > 0 ? T(scaledHeights[level - 1]) : T(-scaledHeights[-level - 1]); }
  T one() const { return 1.0; }
  std::array<T, 3> normal(Index t) const { return mesh.normals[t]; }
};

struct ExactContext {
  using T = mpz_class;
  const SourceMesh& mesh;
  const std::vector<double>& heights;
  int gridExponent;
  Index origin;

  T difference(Index a, Index b, int axis) const {
    if (a == b) return 0;
    return toInteger(coordinate(mesh.vertices[a], axis), gridExponent) -
           toInteger(coordinate(mesh.vertices[b], axis), gridExponent);
  }
  T local(Index v, int axis) const { return difference(v, origin, axis); }
  T height(Index level) const { return toInteger(level > 0 ? heights[level - 1] : -heights[-level - 1], gridExponent); }
  T one() const { return 1; }
  std::array<T, 3> normal(Index t) const {
    const auto& f = mesh.triangles[t];
    std::array<T, 3> u, v;
    for (int k = 0; k < 3; ++k) {
      u[k] = difference(f[1], f[0], k);
      v[k] = difference(f[2], f[0], k);
    }
    return {T(u[1] * v[2] - u[2] * v[1]), T(u[2] * v[0] - u[0] * v[2]), T(u[0] * v[1] - u[1] * v[0])};
  }
};

// numerator / denominator * 2^exponent, rounded to the nearest double.
double roundedQuotient(const mpz_class& numerator, const mpz_class& denominator, int exponent, bool* exact = nullptr) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpq_class quotient;
  quotient.get_num() = numerator;
  quotient.get_den() = denominator;
  if (sgn(denominator) < 0) {
    quotient.get_num() = -numerator;
    quotient.get_den() = -denominator;
  }
  const int lost = mpfr_set_q(value, quotient.get_mpq_t(), MPFR_RNDN);
  if (exact != nullptr && lost != 0) *exact = false;
  mpfr_mul_2si(value, value, exponent, MPFR_RNDN);
  const double result = mpfr_get_d(value, MPFR_RNDN);
  mpfr_clear(value);
  return result + 0.0;
}

bool isNegative(const mpz_class& x) { return sgn(x) < 0; }

// n_t . (v - a_t) - level * height * nz_t: for a face that faces up, the sign of v's height above plane + level.
template <class C>
typename C::T heightValue(const C& c, Index t, Index v, Index level) {
  using T = typename C::T;
  const auto n = c.normal(t);
  const Index a = c.mesh.triangles[t][0];
  T r = n[0] * c.difference(v, a, 0) + n[1] * c.difference(v, a, 1) + n[2] * c.difference(v, a, 2);
  if (level != 0) r = r - n[2] * c.height(level);
  return r;
}

template <class C>
std::array<typename C::T, 3> lineCoefficients(const C& c, const PlanLine& line, Index face) {
  using T = typename C::T;
  std::array<T, 3> r;
  if (line.kind == PlanLine::Edge) {
    r[0] = c.difference(line.a, line.b, 1);
    r[1] = c.difference(line.b, line.a, 0);
    r[2] = -(r[0] * c.local(line.a, 0) + r[1] * c.local(line.a, 1));
    return r;
  }
  const auto n = c.normal(line.a);
  const auto m = c.normal(face);
  const Index a = c.mesh.triangles[line.a][0];
  const Index b = c.mesh.triangles[face][0];
  const T obstacle = n[0] * c.local(a, 0) + n[1] * c.local(a, 1) + n[2] * c.local(a, 2);
  const T floor = m[0] * c.local(b, 0) + m[1] * c.local(b, 1) + m[2] * c.local(b, 2);
  r[0] = n[2] * m[0] - m[2] * n[0];
  r[1] = n[2] * m[1] - m[2] * n[1];
  r[2] = m[2] * obstacle - n[2] * floor;
  if (line.b != 0) r[2] = r[2] - n[2] * m[2] * c.height(line.b);
  if (c.mesh.facing[line.a] < 0)
    for (T& x : r) x = -x;
  return r;
}

template <class C>
Homogeneous<typename C::T> rawHomogeneous(const C& c, const PlanPoint& p) {
  using T = typename C::T;
  if (p.kind == PlanPoint::Source) return {c.local(p.a, 0), c.local(p.a, 1), c.one()};
  if (p.kind == PlanPoint::EdgePlane) {
    const T ha = heightValue(c, p.c, p.a, p.d);
    const T hb = heightValue(c, p.c, p.b, p.d);
    return {T(c.local(p.a, 0) * hb - c.local(p.b, 0) * ha), T(c.local(p.a, 1) * hb - c.local(p.b, 1) * ha), T(hb - ha)};
  }
  const auto l = lineCoefficients(c, p.firstLine(), p.face);
  const auto m = lineCoefficients(c, p.secondLine(), p.face);
  return {T(l[1] * m[2] - m[1] * l[2]), T(l[2] * m[0] - m[2] * l[0]), T(l[0] * m[1] - m[0] * l[1])};
}

template <class T>
T determinant(const Homogeneous<T>& a, const Homogeneous<T>& b, const Homogeneous<T>& c) {
  return a[0] * (b[1] * c[2] - c[1] * b[2]) - a[1] * (b[0] * c[2] - c[0] * b[2]) + a[2] * (b[0] * c[1] - c[0] * b[1]);
}

// Heights of two planes at a point, as numerator over positive denominators: sign of z_f - z_g.
template <class C>
typename C::T heightDifference(const C& c, const Homogeneous<typename C::T>& h, Index f, Index g) {
  using T = typename C::T;
  const auto n = c.normal(f);
  const auto m = c.normal(g);
  const Index a = c.mesh.triangles[f][0];
  const Index b = c.mesh.triangles[g][0];
  const T df = n[0] * c.local(a, 0) + n[1] * c.local(a, 1) + n[2] * c.local(a, 2);
  const T dg = m[0] * c.local(b, 0) + m[1] * c.local(b, 1) + m[2] * c.local(b, 2);
  const T zf = df * h[2] - n[0] * h[0] - n[1] * h[1];  // times 1 / (n_z w)
  const T zg = dg * h[2] - m[0] * h[0] - m[1] * h[1];  // times 1 / (m_z w)
  return zf * m[2] - zg * n[2];
}

}  // namespace

PlanKernel::PlanKernel(std::shared_ptr<const SourceMesh> mesh, std::vector<double> heights)
    : mesh_(std::move(mesh)), heights_(std::move(heights)), grid_(mesh_->grid) {
  const int scale = mesh_->grid.scaleExponent();
  for (const double h : heights_) {
    grid_.include(h);
    scaledHeights_.push_back(std::ldexp(h, scale));
  }
  sign_ = grid_.signRule(scale);
}

std::optional<Index> PlanKernel::levelOf(double height) const {
  for (std::size_t i = 0; i < heights_.size(); ++i)
    if (heights_[i] == height) return static_cast<Index>(i) + 1;
  return std::nullopt;
}

int PlanKernel::heightSign(Index face, Index vertex, Index level, ExactFallbacks& count) const {
  const int s = sign_(heightValue(DoubleContext{*mesh_, scaledHeights_, 0}, face, vertex, level));
  if (s != kUnknownSign) return s;
  ++count.height;
  return sgn(heightValue(ExactContext{*mesh_, heights_, grid_.low, 0}, face, vertex, level));
}

int PlanKernel::orientation(Index a, Index b, Index c, ExactFallbacks& count) const {
  const Vec3 &pa = mesh_->scaled[a], &pb = mesh_->scaled[b], &pc = mesh_->scaled[c];
  const double left = (pa.x - pc.x) * (pb.y - pc.y);
  const double right = (pa.y - pc.y) * (pb.x - pc.x);
  const double value = left - right;
  // Each factor and product loses at most u, the difference one more: 4 u (|l| + |r|); 6 u covers the bound's own loss.
  const double bound = (std::fabs(left) + std::fabs(right)) * (6 * 0x1p-53) + sign_.slack;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  const auto evaluate = [&](const auto& context) -> typename std::decay_t<decltype(context)>::T {
    return context.difference(a, c, 0) * context.difference(b, c, 1) -
           context.difference(a, c, 1) * context.difference(b, c, 0);
  };
  const int s = sign_(evaluate(DoubleContext{*mesh_, scaledHeights_, 0}));
  if (s != kUnknownSign) return s;
  ++count.orientation;
  const mpz_class exact = evaluate(ExactContext{*mesh_, heights_, grid_.low, 0});
  return sgn(exact);
}

bool PlanKernel::coplanar(Index face, Index other, ExactFallbacks& count) const {
  const auto& f = mesh_->triangles[face];
  for (const Index v : mesh_->triangles[other])
    if (v != f[0] && v != f[1] && v != f[2] && heightSign(face, v, 0, count) != 0) return false;
  return true;
}

Homogeneous<ErrorDouble> PlanKernel::homogeneous(const PlanPoint& point, Index origin) const {
  auto h = rawHomogeneous(DoubleContext{*mesh_, scaledHeights_, origin}, point);
  const int s = sign_(h[2]);
  if (s == 1) return h;
  if (s == -1) return {-h[0], -h[1], -h[2]};
  const ErrorDouble unknown(0, std::numeric_limits<double>::infinity());
  return {unknown, unknown, ErrorDouble(1, std::numeric_limits<double>::infinity())};
}

Homogeneous<mpz_class> PlanKernel::exactHomogeneous(const PlanPoint& point, Index origin) const {
  auto h = rawHomogeneous(ExactContext{*mesh_, heights_, grid_.low, origin}, point);
  if (isNegative(h[2]))
    for (mpz_class& x : h) x = -x;
  return h;
}

std::array<ErrorDouble, 3> PlanKernel::coefficients(const PlanLine& line, Index face, Index origin) const {
  return lineCoefficients(DoubleContext{*mesh_, scaledHeights_, origin}, line, face);
}

std::array<mpz_class, 3> PlanKernel::exactCoefficients(const PlanLine& line, Index face, Index origin) const {
  return lineCoefficients(ExactContext{*mesh_, heights_, grid_.low, origin}, line, face);
}

ApproximatePoint PlanKernel::approximate(const Homogeneous<ErrorDouble>& h, const PlanPoint& point,
                                         Index origin) const {
  if (point.kind == PlanPoint::Source) return {h[0].value, h[1].value, std::max(h[0].error, h[1].error) + sign_.slack};
  const ErrorDouble x = h[0] / h[2];
  const ErrorDouble y = h[1] / h[2];
  const double error = std::max(x.error, y.error);
  const double size = std::fabs(x.value) + std::fabs(y.value) + 1;
  if (error < kCoarse * size) return {x.value, y.value, error + sign_.slack};
  const auto exact = exactHomogeneous(point, origin);
  const int scale = grid_.low + mesh_->grid.scaleExponent();
  const double ex = std::ldexp(nearestDouble(mpq_class(exact[0], exact[2])), scale);
  const double ey = std::ldexp(nearestDouble(mpq_class(exact[1], exact[2])), scale);
  // Half a unit in the last place, doubled for the scaling; an underflow is within the slack.
  return {ex, ey, std::max(std::fabs(ex), std::fabs(ey)) * 0x1p-52 + sign_.slack};
}

int PlanKernel::orientation(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, Index origin,
                            ExactFallbacks& count) const {
  if (a == b || b == c || a == c) return 0;
  const int s = sign_(determinant(homogeneous(a, origin), homogeneous(b, origin), homogeneous(c, origin)));
  if (s != kUnknownSign) return s;
  ++count.orientation;
  return sgn(determinant(exactHomogeneous(a, origin), exactHomogeneous(b, origin), exactHomogeneous(c, origin)));
}

int PlanKernel::compare(const PlanPoint& a, const PlanPoint& b, int axis, Index origin, ExactFallbacks& count) const {
  if (a == b) return 0;
  const auto ha = homogeneous(a, origin);
  const auto hb = homogeneous(b, origin);
  const int s = sign_(ha[axis] * hb[2] - hb[axis] * ha[2]);
  if (s != kUnknownSign) return s;
  ++count.order;
  const auto ea = exactHomogeneous(a, origin);
  const auto eb = exactHomogeneous(b, origin);
  const mpz_class difference = ea[axis] * eb[2] - eb[axis] * ea[2];
  return sgn(difference);
}

int PlanKernel::compareHeight(const PlanPoint& point, Index f, Index g, ExactFallbacks& count) const {
  if (f == g) return 0;
  const Index origin = mesh_->triangles[f][0];
  const int flip = mesh_->facing[f] * mesh_->facing[g];
  const int s =
      sign_(heightDifference(DoubleContext{*mesh_, scaledHeights_, origin}, homogeneous(point, origin), f, g));
  if (s != kUnknownSign) return s * flip;
  ++count.height;
  return flip * sgn(heightDifference(ExactContext{*mesh_, heights_, grid_.low, origin}, exactHomogeneous(point, origin),
                                     f, g));
}

int PlanKernel::side(const PlanLine& line, Index face, const PlanPoint& point, Index origin,
                     ExactFallbacks& count) const {
  const auto l = coefficients(line, face, origin);
  const auto h = homogeneous(point, origin);
  const int s = sign_(l[0] * h[0] + l[1] * h[1] + l[2] * h[2]);
  if (s != kUnknownSign) return s;
  ++count.side;
  const auto el = exactCoefficients(line, face, origin);
  const auto eh = exactHomogeneous(point, origin);
  const mpz_class value = el[0] * eh[0] + el[1] * eh[1] + el[2] * eh[2];
  return sgn(value);
}

std::array<mpq_class, 3> PlanKernel::exactPosition(const PlanPoint& point, Index face) const {
  const Index origin = mesh_->triangles[face][0];
  const auto h = exactHomogeneous(point, origin);
  const ExactContext context{*mesh_, heights_, grid_.low, origin};
  const auto n = context.normal(face);
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
  const Index origin = mesh_->triangles[face][0];
  const auto h = exactHomogeneous(point, origin);
  const ExactContext context{*mesh_, heights_, grid_.low, origin};
  const auto n = context.normal(face);
  const Vec3& o = mesh_->vertices[origin];
  // (local + base) on the grid over a common denominator, without reducing fractions
  const auto round = [&](const mpz_class& numerator, const mpz_class& denominator, double base) {
    const mpz_class whole = numerator + toInteger(base, grid_.low) * denominator;
    return roundedQuotient(whole, denominator, grid_.low, exact);
  };
  const mpz_class zNumerator = -(n[0] * h[0] + n[1] * h[1]);
  const mpz_class zDenominator = n[2] * h[2];
  return {round(h[0], h[2], o.x), round(h[1], h[2], o.y), round(zNumerator, zDenominator, o.z)};
}

double nearestDouble(const mpq_class& value) { return roundedQuotient(value.get_num(), value.get_den(), 0); }

}  // namespace footfall
