// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/plan_polygon.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace footfall::detail {
namespace {

constexpr double kUnit = MarginSurface::kUnit;

void keep(std::vector<PlanVector>& corners, int axis, double sign, double border) {
  const auto inside = [&](const PlanVector& p) { return sign * ((axis == 0 ? p.x : p.y) - border); };
  if (std::none_of(corners.begin(), corners.end(), [&](const PlanVector& p) { return inside(p) < 0; })) return;
  std::vector<PlanVector> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanVector &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double a = inside(p), b = inside(q);
    if (a >= 0) kept.push_back(p);
    if (a * b >= 0) continue;
    // The same from either side, so that neighbours' common edges stay common.
    const bool isForward = std::array{p.x, p.y} < std::array{q.x, q.y};
    PlanVector cut = roundToUnit(isForward ? p + (a / (a - b)) * (q - p) : q + (b / (b - a)) * (p - q));
    (axis == 0 ? cut.x : cut.y) = border;
    kept.push_back(cut);
  }
  corners = std::move(kept);
}

}  // namespace

ClipBox::ClipBox(const MarginSurface& surface) {
  for (Index side = 0; side < surface.sideCount(); ++side) {
    const PlanVector p = surface.begin(side);
    lower_ = {std::min(lower_[0], p.x), std::min(lower_[1], p.y)};
    upper_ = {std::max(upper_[0], p.x), std::max(upper_[1], p.y)};
  }
  constexpr double kEnd = 0x1p36 - kUnit;  // Grid::scaleExponent(): all coordinates are below 2^36
  const double more = roundToUnit(diagonal() / 64) + 64 * MarginSurface::kSlack;
  for (int k = 0; k < 2; ++k) {
    lower_[k] = std::max(roundToUnit(lower_[k]) - more, -kEnd);
    upper_[k] = std::min(roundToUnit(upper_[k]) + more, kEnd);
  }
}

void ClipBox::clip(std::vector<PlanVector>& corners) const {
  for (int axis = 0; axis < 2; ++axis) {
    keep(corners, axis, 1, lower_[axis]);
    keep(corners, axis, -1, upper_[axis]);
  }
}

std::vector<PlanVector> hullOf(std::vector<PlanVector> places) {
  const auto key = [](const PlanVector& p) { return std::array{p.x, p.y}; };
  std::sort(places.begin(), places.end(), [&](const PlanVector& a, const PlanVector& b) { return key(a) < key(b); });
  places.erase(std::unique(places.begin(), places.end(),
                           [&](const PlanVector& a, const PlanVector& b) { return key(a) == key(b); }),
               places.end());
  // Fewer than 54 bits and a sign each.
  const auto inUnits = [](double x) { return static_cast<__int128>(static_cast<std::int64_t>(x / kUnit)); };
  const auto isLeft = [&](const PlanVector& a, const PlanVector& b, const PlanVector& c) {
    return (inUnits(b.x) - inUnits(a.x)) * (inUnits(c.y) - inUnits(a.y)) >
           (inUnits(b.y) - inUnits(a.y)) * (inUnits(c.x) - inUnits(a.x));
  };
  std::vector<PlanVector> hull;
  const auto add = [&](const PlanVector& p, std::size_t from) {
    while (hull.size() >= from + 2 && !isLeft(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
    hull.push_back(p);
  };
  for (const PlanVector& p : places) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = places.rbegin() + 1; p < places.rend(); ++p) add(*p, lower);
  hull.pop_back();
  return hull;
}

}  // namespace footfall::detail
