// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/source_predicates.hpp"

#include <gmpxx.h>
#include <mpfr.h>

#include <array>
#include <cmath>

#include "core/exact/error_double.hpp"

namespace footfall {
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

template <class T>
std::array<T, 3> normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<T, 3> u{T(b.x) - T(a.x), T(b.y) - T(a.y), T(b.z) - T(a.z)};
  const std::array<T, 3> v{T(c.x) - T(a.x), T(c.y) - T(a.y), T(c.z) - T(a.z)};
  return {T(u[1] * v[2] - u[2] * v[1]), T(u[2] * v[0] - u[0] * v[2]), T(u[0] * v[1] - u[1] * v[0])};
}

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
int compareWithIrrationalSlope(const std::array<mpq_class, 3>& n, double degrees) {
  const mpq_class squared = n[2] * n[2];
  const mpq_class ratio = squared / (squared + n[0] * n[0] + n[1] * n[1]);
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
  if (areModerate(a, b, c)) {
    const SignRule sign;
    bool unknown = false;
    for (const ErrorDouble& component : normal<ErrorDouble>(a, b, c)) {
      const int s = sign(component);
      if (s == 1 || s == -1) return false;
      unknown = unknown || s == kUnknownSign;
    }
    if (!unknown) return true;
  }
  const auto n = normal<mpq_class>(a, b, c);
  return sgn(n[0]) == 0 && sgn(n[1]) == 0 && sgn(n[2]) == 0;
}

int facing(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (areModerate(a, b, c)) {
    const int s = SignRule{}(normal<ErrorDouble>(a, b, c)[2]);
    if (s != kUnknownSign) return s;
  }
  return sgn(normal<mpq_class>(a, b, c)[2]);
}

bool isWithinSlope(const Vec3& a, const Vec3& b, const Vec3& c, double degrees, bool* beyondDoubles) {
  if (facing(a, b, c) <= 0) return false;
  const int quarters = quartersOfSquaredCosine(degrees);
  if (areModerate(a, b, c)) {
    const auto n = normal<ErrorDouble>(a, b, c);
    const ErrorDouble squared = n[2] * n[2];
    const ErrorDouble flat = n[0] * n[0] + n[1] * n[1];
    ErrorDouble difference;
    if (quarters != 0) {
      difference = squared * ErrorDouble(4 - quarters) - flat * ErrorDouble(quarters);
    } else {
      // The cosine of the library is good to far better than 2^-46; squaring and the degrees add a few units.
      const double cosine = std::cos(degrees * (3.14159265358979323846 / 180));
      const ErrorDouble limit(cosine * cosine, 0x1p-46);
      difference = squared - limit * (squared + flat);
    }
    const int s = SignRule{}(difference);
    if (s != kUnknownSign && (quarters != 0 || s != 0)) return s >= 0;
  }
  if (beyondDoubles != nullptr) *beyondDoubles = true;
  const auto n = normal<mpq_class>(a, b, c);
  if (quarters != 0) return n[2] * n[2] * (4 - quarters) >= (n[0] * n[0] + n[1] * n[1]) * quarters;
  return compareWithIrrationalSlope(n, degrees) > 0;
}

}  // namespace footfall
