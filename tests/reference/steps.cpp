// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/steps.hpp"

#include <algorithm>

#include "tests/reference/walkable_area.hpp"

namespace footfall::reference {
namespace {

/// The height of a straight edge over a place of the plan on it.
Rational heightAt(const Point3& from, const Point3& to, const Point2& place) {
  const Rational whole = from.x != to.x ? Rational(to.x - from.x) : Rational(to.y - from.y);
  const Rational part = from.x != to.x ? Rational(place.x - from.x) : Rational(place.y - from.y);
  return from.z + part / whole * (to.z - from.z);
}

bool isOn(const Point2& a, const Point2& b, const Point2& p) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// Heights of a triangle straight over a place, which no corner has.
std::vector<Rational> heightsOver(const std::array<Point3, 3>& t, const Point2& place) {
  std::vector<Rational> heights;
  if (const Polygon polygon = planTriangle(t); !polygon.empty()) {
    for (std::size_t k = 0; k < 3; ++k)
      if (turn(polygon[k], polygon[(k + 1) % 3], place) < 0) return {};
    return {planeThrough(t)->at(place)};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &a = t[k], &b = t[(k + 1) % 3];
    if (!(planOf(a) == planOf(b)) && isOn(planOf(a), planOf(b), place)) heights.push_back(heightAt(a, b, place));
  }
  return heights;
}

}  // namespace

std::optional<Segment2> sharedStretch(const BorderEdge3& a, const BorderEdge3& b) {
  const Point2 p = planOf(a.from), q = planOf(a.to), r = planOf(b.from), s = planOf(b.to);
  if (turn(p, q, r) != 0 || turn(p, q, s) != 0) return std::nullopt;  // true of most pairs, and cheap
  if ((q.x - p.x) * (s.x - r.x) + (q.y - p.y) * (s.y - r.y) >= 0) return std::nullopt;
  return commonPart({p, q}, {r, s});
}

bool canStepAt(const Environment& environment, const BorderEdge3& a, const BorderEdge3& b, const Point2& place,
               const Rational& step, const Rational& clearance) {
  const Rational za = heightAt(a.from, a.to, place), zb = heightAt(b.from, b.to, place);
  if (abs(za - zb) > step) return false;
  const Rational low = std::min(za, zb) + step, high = std::max(za, zb) + clearance;
  const PlanBox box = boxOf(Polygon{place});
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    if (isBeside(environment, t, box)) continue;
    const auto corners = cornersOf(environment, t);
    if (isOutOf(corners, low, high) || isDegenerate(corners)) continue;
    const auto heights = heightsOver(corners, place);
    if (heights.empty()) continue;
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    if (*most > low && *least < high) return false;
  }
  return true;
}

}  // namespace footfall::reference
