// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/source_predicates.hpp"

#include <gmpxx.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/vector.hpp"
#include "core/exact/error_double.hpp"
#include "core/exact/grid_integer.hpp"

namespace footfall::detail {
namespace {

// Products of four coordinates neither overflow nor lose residuals to underflow when every coordinate is zero or
// within these bounds: a difference is a multiple of 2^-252, a product of four of 2^-1008.
bool isModerate(double x) {
  const double size = std::fabs(x);
  return size == 0 || (size >= 0x1p-200 && size <= 0x1p200);
}

bool areModerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (const Vec3* p : {&a, &b, &c})
    if (!isModerate(p->x) || !isModerate(p->y) || !isModerate(p->z)) return false;
  return true;
}

std::array<ErrorDouble, 3> normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  using E = ErrorDouble;
  return cross<E>({E(b.x) - E(a.x), E(b.y) - E(a.y), E(b.z) - E(a.z)},
                  {E(c.x) - E(a.x), E(c.y) - E(a.y), E(c.z) - E(a.z)});
}

// The smallest grid with the three points on it.
Grid gridOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  Grid grid;
  for (const Vec3* p : {&a, &b, &c})
    for (const double x : {p->x, p->y, p->z}) grid.include(x);
  return grid;
}

// The exact normal, in units of the squared grid.
template <class T>
std::array<T, 3> exactNormal(const Vec3& a, const Vec3& b, const Vec3& c, const Grid& grid) {
  const bool narrow = grid.width() <= kNarrowGrid;
  const auto minus = [&](double x, double y) { return gridDifference<T>(x, y, grid.low, narrow); };
  return cross<T>({minus(b.x, a.x), minus(b.y, a.y), minus(b.z, a.z)},
                  {minus(c.x, a.x), minus(c.y, a.y), minus(c.z, a.z)});
}

// The normal has 2 D + 1 bits with D = Grid::width() + 1, squares 4 D + 2, and compared values fewer than 4 D + 6; two
// limbs more are always enough (FixedInteger).
constexpr int kWidestGrid = (64 * (FixedInteger::kCapacity - 2) - 6) / 4 - 1;

// Hands the exact normal to `decide`, as the integers that it needs.
template <class Decide>
auto withExactNormal(const Vec3& a, const Vec3& b, const Vec3& c, const Decide& decide) {
  const Grid grid = gridOf(a, b, c);
  if (grid.width() <= kWidestGrid) return decide(exactNormal<FixedInteger>(a, b, c, grid));
  return decide(exactNormal<mpz_class>(a, b, c, grid));
}

// A product of two differences that underflows loses at most 2^-1075; overflow ends in no decision.
constexpr double kUnderflow = 0x1p-1000;

// cos^2 of the angle where it is rational, as numerator over 4; 0 elsewhere (Niven's theorem: no other angle with a
// rational number of degrees between 0 and 90 has a rational squared cosine).
int quartersOfSquaredCosine(double degrees) {
  if (degrees == 30) return 3;
  if (degrees == 45) return 2;
  if (degrees == 60) return 1;
  return 0;
}

// Sign of nz^2 - cos^2(degrees) |n|^2 for an angle with irrational squared cosine: refined until it is decided, which
// ends because the two sides are never equal.
int compareWithIrrationalSlope(const std::array<mpz_class, 3>& n, double degrees) {
  const mpz_class squared = n[2] * n[2];
  mpq_class ratio(squared, squared + n[0] * n[0] + n[1] * n[1]);
  ratio.canonicalize();
  for (mpfr_prec_t precision = 128;; precision *= 2) {
    mpfr_t low, high, pi;
    mpfr_inits2(precision, low, high, pi, static_cast<mpfr_ptr>(nullptr));
    // angle in radians, rounded both ways; cosine falls with the angle
    mpfr_const_pi(pi, MPFR_RNDU);
    mpfr_mul_d(high, pi, degrees, MPFR_RNDU);
    mpfr_div_ui(high, high, 180, MPFR_RNDU);
    mpfr_const_pi(pi, MPFR_RNDD);
    mpfr_mul_d(low, pi, degrees, MPFR_RNDD);
    mpfr_div_ui(low, low, 180, MPFR_RNDD);
    mpfr_swap(low, high);
    mpfr_cos(low, low, MPFR_RNDD);
    mpfr_cos(high, high, MPFR_RNDU);
    mpfr_sqr(low, low, MPFR_RNDD);
    mpfr_sqr(high, high, MPFR_RNDU);
    const bool above = mpfr_cmp_q(high, ratio.get_mpq_t()) < 0;
    const bool below = mpfr_cmp_q(low, ratio.get_mpq_t()) > 0;
    mpfr_clears(low, high, pi, static_cast<mpfr_ptr>(nullptr));
    if (above) return 1;
    if (below) return -1;
  }
}

}  // namespace

bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}})
    if (filteredArea(u[i], u[j], v[i], v[j], kUnderflow)) return false;
  if (areModerate(a, b, c)) {
    const SignRule sign;
    bool unknown = false;
    for (const ErrorDouble& component : normal(a, b, c)) {
      const MaybeSign s = sign(component);
      if (s.value_or(0) != 0) return false;
      unknown = unknown || !s;
    }
    if (!unknown) return true;
  }
  return withExactNormal(a, b, c, [](const auto& n) { return sgn(n[0]) == 0 && sgn(n[1]) == 0 && sgn(n[2]) == 0; });
}

int facing(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (const MaybeSign s = filteredArea(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y, kUnderflow)) return *s;
  if (areModerate(a, b, c))
    if (const MaybeSign s = SignRule{}(normal(a, b, c)[2])) return *s;
  return withExactNormal(a, b, c, [](const auto& n) { return sgn(n[2]); });
}

// The cosine of the library is good to far better than 2^-46; squaring and the degrees add a few units.
double slopeLimit(double maxSlope, double tolerance) {
  return std::min(maxSlope + tolerance, std::nextafter(90.0, 0.0));
}

SlopeLimit::SlopeLimit(double degrees) : quarters_(quartersOfSquaredCosine(degrees)) {
  const double cosine = std::cos(degrees * (3.14159265358979323846 / 180));
  squared_ = quarters_ != 0 ? ErrorDouble(quarters_ / 4.0) : ErrorDouble(cosine * cosine, 0x1p-46);
}

// First with one bound for all roundings. Let each component be off by at most e, m the sum of their sizes, and u =
// 2^-53. The square of the length is off by at most 2 m e + 3 e^2, its product with cos^2 <= 1 by no more, nz^2 by
// 2 m e + e^2: together below 4 e (m + e). The error of cos^2, at most 2^-46, and the roundings, each at most u of
// numbers that are at most m^2, cost less than 2^-45 m^2; twice as much is allowed, for the bound's own roundings.
MaybeSign SlopeLimit::compare(const std::array<ErrorDouble, 3>& normal, const SignRule& sign) const {
  const double x = normal[0].value, y = normal[1].value, z = normal[2].value;
  const double e = std::max({normal[0].error, normal[1].error, normal[2].error}) + sign.slack;
  const double m = std::fabs(x) + std::fabs(y) + std::fabs(z);
  const double value = z * z - squared_.value * (x * x + y * y + z * z);
  const double bound = 8 * e * (m + e) + 0x1p-44 * (m * m) + sign.slack;
  if (m > 0x1p-400 && std::fabs(value) > bound) return value > 0 ? 1 : -1;

  const ErrorDouble steep = normal[2] * normal[2], flat = normal[0] * normal[0] + normal[1] * normal[1];
  const MaybeSign exactly = sign(quarters_ != 0 ? steep * ErrorDouble(4 - quarters_) - flat * ErrorDouble(quarters_)
                                                : steep - squared_ * (steep + flat));
  // no angle with an irrational squared cosine is ever met exactly
  if (!exactly || (*exactly == 0 && quarters_ == 0)) return std::nullopt;
  return *exactly >= 0 ? 1 : -1;
}

bool isWithinSlope(const Vec3& a, const Vec3& b, const Vec3& c, double degrees, bool* beyondDoubles) {
  if (facing(a, b, c) <= 0) return false;
  if (areModerate(a, b, c))
    if (const MaybeSign s = SlopeLimit(degrees).compare(normal(a, b, c), SignRule{})) return *s > 0;
  if (beyondDoubles != nullptr) *beyondDoubles = true;
  const int quarters = quartersOfSquaredCosine(degrees);
  if (quarters != 0)
    return withExactNormal(a, b, c, [quarters](const auto& n) {
      using T = std::decay_t<decltype(n[0])>;
      const T steep = n[2] * n[2] * T(4 - quarters), flat = (n[0] * n[0] + n[1] * n[1]) * T(quarters);
      return sgn(T(steep - flat)) >= 0;
    });
  return compareWithIrrationalSlope(exactNormal<mpz_class>(a, b, c, gridOf(a, b, c)), degrees) > 0;
}

}  // namespace footfall::detail
