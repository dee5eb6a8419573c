// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/gaps.hpp"

#include <algorithm>

#include "tests/reference/walkable_area.hpp"

namespace footfall::reference {
namespace {

using Corners = std::vector<Point3>;

/// The part of a convex polygon in space on one side of an upright plane.
Corners clipped(const Corners& polygon, const Linear& keep) {
  Corners left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational atA = keep.at(planOf(a)), atB = keep.at(planOf(b));
    if (atA >= 0) left.push_back(a);
    if ((atA < 0 && atB > 0) || (atA > 0 && atB < 0)) {
      const Rational t = atA / (atA - atB);
      left.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
    }
  }
  return left;
}

Linear negated(const Linear& f) { return {-f.a, -f.b, -f.c}; }

}  // namespace

Point3 placeOn(const BorderEdge3& edge, const Rational& part) {
  const auto between = [&](const Rational& from, const Rational& to) { return Rational(from + part * (to - from)); };
  return {between(edge.from.x, edge.to.x), between(edge.from.y, edge.to.y), between(edge.from.z, edge.to.z)};
}

bool canStepOver(const Environment& environment, const BorderEdge3& a, const BorderEdge3& b, const Point3& p,
                 const Point3& q, const Rational& step, const Rational& clearance, const Rational& gap) {
  const Rational dx = q.x - p.x, dy = q.y - p.y, square = dx * dx + dy * dy;
  if (square == 0 || square > gap * gap || abs(p.z - q.z) > step) return false;
  if (turn(planOf(a.from), planOf(a.to), planOf(q)) >= 0) return false;
  if (turn(planOf(b.from), planOf(b.to), planOf(p)) >= 0) return false;
  const Rational low = std::min(p.z, q.z) + step, high = std::max(p.z, q.z) + clearance;
  const Linear along{dx, dy, -(dx * p.x + dy * p.y)};           // 0 at p, `square` at q
  const Linear before{-dx, -dy, square + dx * p.x + dy * p.y};  // 0 at q
  const Linear across = leftOf(planOf(p), planOf(q));
  const PlanBox box = boxOf(Segment2{planOf(p), planOf(q)});
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    if (isBeside(environment, t, box)) continue;
    const auto corners = cornersOf(environment, t);
    if (isOutOf(corners, low, high) || isDegenerate(corners)) continue;
    Corners polygon(corners.begin(), corners.end());
    for (const Linear& keep : {across, negated(across), along, before}) polygon = clipped(polygon, keep);
    if (polygon.empty()) continue;
    const auto [least, most] =
        std::minmax_element(polygon.begin(), polygon.end(), [](const Point3& u, const Point3& v) { return u.z < v.z; });
    if (most->z > low && least->z < high) return false;
  }
  return true;
}

}  // namespace footfall::reference
