// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/generic_place.hpp"

#include <utility>

namespace footfall::detail {

ExactPoint exactPoint(const Vec3& place) { return {mpq_class(place.x), mpq_class(place.y), mpq_class(place.z)}; }

int GenericNumber::sign() const {
  if (const int s = sgn(value); s != 0) return s;
  if (const int s = sgn(firstStep); s != 0) return s;
  return sgn(secondStep);
}

GenericPlace::GenericPlace(mpq_class x, mpq_class y, const mpq_class& towardsX, const mpq_class& towardsY)
    : x_(std::move(x)), y_(std::move(y)), stepX_(towardsX - x_), stepY_(towardsY - y_) {
  if (stepX_ == 0 && stepY_ == 0) stepX_ = 1;
}

int GenericPlace::side(const ExactPoint& a, const ExactPoint& b) const {
  const mpq_class dx = b[0] - a[0], dy = b[1] - a[1];
  // The second step is the first one turned to the left.
  return GenericNumber{dx * (y_ - a[1]) - dy * (x_ - a[0]), dx * stepY_ - dy * stepX_, dx * stepX_ + dy * stepY_}
      .sign();
}

bool GenericPlace::isInside(const std::array<ExactPoint, 3>& corners) const {
  const int first = side(corners[0], corners[1]);
  return first != 0 && side(corners[1], corners[2]) == first && side(corners[2], corners[0]) == first;
}

std::optional<GenericNumber> GenericPlace::heightOf(const std::array<ExactPoint, 3>& corners) const {
  const auto& [a, b, c] = corners;
  const mpq_class ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const mpq_class vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const mpq_class nz = ux * vy - uy * vx;
  if (nz == 0) return std::nullopt;
  const mpq_class slopeX = (uz * vy - uy * vz) / nz, slopeY = (ux * vz - uz * vx) / nz;
  return GenericNumber{a[2] + slopeX * (x_ - a[0]) + slopeY * (y_ - a[1]), slopeX * stepX_ + slopeY * stepY_,
                       slopeY * stepX_ - slopeX * stepY_};
}

}  // namespace footfall::detail
