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

bool ClipBox::clip(std::vector<PlanVector>& corners) const {
  if (std::all_of(corners.begin(), corners.end(), [&](const PlanVector& p) { return holds(p); })) return false;
  for (int axis = 0; axis < 2; ++axis) {
    keep(corners, axis, 1, lower_[axis]);
    keep(corners, axis, -1, upper_[axis]);
  }
  return true;
}

namespace {

bool precedes(const PlanVector& p, const PlanVector& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

/// True when c is to the left of the line from a to b; exactly.
bool isLeft(const PlanVector& a, const PlanVector& b, const PlanVector& c) {
  // Differences, products and the last difference lose at most 4 u (|l| + |r|) together, u = 2^-53.
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double bound = (std::fabs(left) + std::fabs(right)) * 0x1p-50;
  if (left - right > bound) return true;
  if (left - right < -bound) return false;
  // Fewer than 54 bits and a sign each.
  const auto inUnits = [](double x) { return static_cast<__int128>(static_cast<std::int64_t>(x / kUnit)); };
  return (inUnits(b.x) - inUnits(a.x)) * (inUnits(c.y) - inUnits(a.y)) >
         (inUnits(b.y) - inUnits(a.y)) * (inUnits(c.x) - inUnits(a.x));
}

// Turns to the left at each corner, once round: it goes up from its first corner in their order, and then down.
bool isConvex(const std::vector<PlanVector>& corners) {
  const std::size_t count = corners.size();
  if (count < 3) return false;
  int turns = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const PlanVector &a = corners[i], &b = corners[(i + 1) % count], &c = corners[(i + 2) % count];
    if (!isLeft(a, b, c)) return false;
    turns += static_cast<int>(precedes(a, b) != precedes(b, c));
  }
  return turns == 2;
}

}  // namespace

std::vector<PlanVector> hullOf(std::vector<PlanVector> places) {
  if (isConvex(places)) {
    std::rotate(places.begin(), std::min_element(places.begin(), places.end(), precedes), places.end());
    return places;
  }
  std::sort(places.begin(), places.end(), precedes);
  places.erase(std::unique(places.begin(), places.end(),
                           [&](const PlanVector& a, const PlanVector& b) { return a.x == b.x && a.y == b.y; }),
               places.end());
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
