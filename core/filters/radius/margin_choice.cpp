// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/margin_choice.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::detail {
namespace {

// Distances to a line have an error of at most 8 units: differences of places are off by one, a product of one of them
// and a unit vector, and the sum of two such, by a few more. A place where two lines cross lies on the clipped edge to
// within two. So what is clipped by three lines, each this far out, holds all that is inside, and more than 24 units
// deep in a polygon is inside.
constexpr double kOut = 16 * MarginSurface::kUnit;
constexpr double kDeep = 64 * MarginSurface::kUnit;

void boxOf(const std::vector<PlanVector>& places, PlanVector& low, PlanVector& high) {
  low = high = places.front();
  for (const PlanVector& p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
}

}  // namespace

std::span<const Index> MarginChoice::neededOn(const std::array<PlanVector, 3>& corners,
                                              std::span<const Index> numbers) {
  if (parts_.size() < numbers.size()) parts_.resize(numbers.size());
  std::size_t count = 0;
  for (const Index number : numbers) {
    Part& part = parts_[count];
    part.margin = number;
    part.isNeeded = true;
    clip(corners, part);
    if (part.corners.empty()) continue;
    boxOf(part.corners, part.low, part.high);
    boxOf(margins_[number].corners, part.marginLow, part.marginHigh);
    ++count;
  }
  needed_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < count && parts_[i].isNeeded; ++k)
      if (k != i && parts_[k].isNeeded && holds(parts_[k], parts_[i])) parts_[i].isNeeded = false;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (parts_[i].isNeeded) needed_.push_back(parts_[i].margin);
  return needed_;
}

void MarginChoice::clip(const std::array<PlanVector, 3>& corners, Part& part) {
  part.corners = margins_[part.margin].corners;
  for (std::size_t k = 0; k < 3 && !part.corners.empty(); ++k) {
    const PlanVector &a = corners[k], &b = corners[(k + 1) % 3];
    const double size = length(b - a);
    if (size < MarginSurface::kShort) continue;
    const PlanVector out = (1 / size) * leftOf(b - a);
    clipped_.clear();
    for (std::size_t i = 0; i < part.corners.size(); ++i) {
      const PlanVector &p = part.corners[i], &q = part.corners[(i + 1) % part.corners.size()];
      const double atP = dot(p - a, out) + kOut, atQ = dot(q - a, out) + kOut;
      if (atP >= 0) clipped_.push_back(p);
      if ((atP > 0 && atQ < 0) || (atP < 0 && atQ > 0)) clipped_.push_back(p + (atP / (atP - atQ)) * (q - p));
    }
    part.corners.swap(clipped_);
  }
}

bool MarginChoice::holds(const Part& outer, const Part& inner) const {
  if (inner.low.x < outer.marginLow.x || inner.low.y < outer.marginLow.y || inner.high.x > outer.marginHigh.x ||
      inner.high.y > outer.marginHigh.y)
    return false;
  const std::vector<PlanVector>& corners = margins_[outer.margin].corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanVector &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double size = length(b - a);
    const PlanVector out = leftOf(b - a);
    for (const PlanVector& p : inner.corners)
      if (!(dot(p - a, out) > kDeep * size)) return false;
  }
  return true;
}

}  // namespace footfall::detail
