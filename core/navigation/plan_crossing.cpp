// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/plan_crossing.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "core/exact/error_double.hpp"

namespace footfall::detail {
namespace {

ErrorDouble area(const Vec3& a, const Vec3& b, const Vec3& p) {
  using E = ErrorDouble;
  return (E(b.x) - E(a.x)) * (E(p.y) - E(a.y)) - (E(b.y) - E(a.y)) * (E(p.x) - E(a.x));
}

mpq_class exactArea(const Vec3& a, const Vec3& b, const Vec3& p) {
  const mpq_class ax(a.x), ay(a.y);
  return (mpq_class(b.x) - ax) * (mpq_class(p.y) - ay) - (mpq_class(b.y) - ay) * (mpq_class(p.x) - ax);
}

/// The value is good to 2^-40 of itself; what underflows is not (the smallest products lose everything).
bool isGood(const ErrorDouble& x) {
  const double size = std::fabs(x.value);
  return size > 0x1p-900 && x.error <= size * 0x1p-40;
}

}  // namespace

double crossingParameter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const ErrorDouble atC = area(a, b, c), atD = area(a, b, d);
  const double sum = atC.value - atD.value;
  if (isGood(atC) && isGood(atD) && std::isfinite(sum)) return std::clamp(atC.value / sum, 0.0, 1.0);
  const mpq_class exactC = exactArea(a, b, c);
  const mpq_class quotient = exactC / (exactC - exactArea(a, b, d));
  return std::clamp(quotient.get_d(), 0.0, 1.0);
}

Vec3 pointBetween(const Vec3& c, const Vec3& d, double parameter) {
  // std::lerp is exact at both ends and monotonic.
  return {std::lerp(c.x, d.x, parameter), std::lerp(c.y, d.y, parameter), std::lerp(c.z, d.z, parameter)};
}

}  // namespace footfall::detail
