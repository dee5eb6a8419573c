// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/drops.hpp"

#include <algorithm>

#include "tests/reference/walkable_area.hpp"

namespace footfall::reference {
namespace {

/// The direction at a right angle to the border, where nothing is walkable; as long as the border.
Point2 outwardsOf(const BorderEdge3& border) { return {border.to.y - border.from.y, border.from.x - border.to.x}; }

/// A triangle that is not vertical covers a place moved by nearly nothing in a direction.
bool coversBeside(const std::array<Point3, 3>& t, const Point2& place, const Point2& direction) {
  const Polygon polygon = planTriangle(t);
  if (polygon.empty()) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Linear inside = leftOf(polygon[k], polygon[(k + 1) % 3]);
    const Rational at = inside.at(place), change = inside.a * direction.x + inside.b * direction.y;
    if (at < 0 || (at == 0 && change <= 0)) return false;
  }
  return true;
}

/// Something lies over a place moved by nearly nothing in a direction, strictly between two heights.
bool isBlockedBeside(const Environment& environment, const Point2& place, const Point2& direction, const Rational& low,
                     const Rational& high) {
  const PlanBox box = boxOf(Polygon{place});
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    if (isBeside(environment, t, box)) continue;
    const auto corners = cornersOf(environment, t);
    if (isOutOf(corners, low, high) || !coversBeside(corners, place, direction)) continue;
    const Rational z = planeThrough(corners)->at(place);
    if (z > low && z < high) return true;
  }
  return false;
}

/// The part of a polygon in space where a linear function of the plan is at least 0.
std::vector<Point3> clipped(const std::vector<Point3>& polygon, const Linear& keep) {
  std::vector<Point3> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational atP = keep.at(planOf(p)), atQ = keep.at(planOf(q));
    if (atP >= 0) rest.push_back(p);
    if ((atP > 0 && atQ < 0) || (atP < 0 && atQ > 0)) {
      const Rational s = atP / (atP - atQ);
      rest.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)});
    }
  }
  return rest;
}

/// Something lies over the segment, strictly between two heights.
bool isBlockedOver(const Environment& environment, const Point2& from, const Point2& to, const Rational& low,
                   const Rational& high) {
  const Linear left = leftOf(from, to), right{-left.a, -left.b, -left.c};
  const Rational dx = to.x - from.x, dy = to.y - from.y;
  const Linear behind{dx, dy, -(dx * from.x + dy * from.y)}, before{-dx, -dy, dx * to.x + dy * to.y};
  const PlanBox box = boxOf(Segment2{from, to});
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    if (isBeside(environment, t, box)) continue;
    const auto corners = cornersOf(environment, t);
    if (isOutOf(corners, low, high) || isDegenerate(corners)) continue;
    std::vector<Point3> part(corners.begin(), corners.end());
    for (const Linear& keep : {left, right, behind, before}) part = clipped(part, keep);
    if (part.empty()) continue;
    const auto [lowest, highest] =
        std::minmax_element(part.begin(), part.end(), [](const Point3& a, const Point3& b) { return a.z < b.z; });
    if (highest->z > low && lowest->z < high) return true;
  }
  return false;
}

}  // namespace

Point3 pointOn(const BorderEdge3& border, const Rational& share) {
  const auto& [a, b] = border;
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

bool isLedgeAt(const Environment& environment, const BorderEdge3& border, const Rational& share,
               const DropAgent& agent) {
  return canStepAt(environment, border, border, planOf(pointOn(border, share)), agent.step, agent.clearance);
}

bool canDropStraight(const Environment& environment, const BorderEdge3& border, const Rational& share,
                     const std::array<Point3, 3>& landing, const DropAgent& agent) {
  const Point3 start = pointOn(border, share);
  const Point2 place = planOf(start), outwards = outwardsOf(border);
  const auto plane = planeThrough(landing);
  if (!plane || !coversBeside(landing, place, outwards)) return false;
  const Rational z = plane->at(place);
  return z < start.z && z >= start.z - agent.depth &&
         !isBlockedBeside(environment, place, outwards, z, start.z + agent.clearance);
}

bool canDropAcross(const Environment& environment, const BorderEdge3& border, const Rational& share,
                   const BorderEdge3& landing, const DropAgent& agent) {
  const Point3 start = pointOn(border, share);
  const Point2 outwards = outwardsOf(border), place = planOf(start);
  const Linear walkable = leftOf(planOf(landing.from), planOf(landing.to));
  const Rational entering = walkable.a * outwards.x + walkable.b * outwards.y;
  if (entering <= 0) return false;
  const Rational t = -walkable.at(place) / entering;  // measured in lengths of the border
  const Rational squared = outwards.x * outwards.x + outwards.y * outwards.y;
  if (t <= 0 || t * t * squared <= agent.least * agent.least || t * t * squared > agent.reach * agent.reach)
    return false;
  const Point2 end{place.x + t * outwards.x, place.y + t * outwards.y};
  const Rational dx = landing.to.x - landing.from.x, dy = landing.to.y - landing.from.y;
  const Rational along = (dx * (end.x - landing.from.x) + dy * (end.y - landing.from.y)) / (dx * dx + dy * dy);
  if (along < 0 || along > 1) return false;
  const Rational z = pointOn(landing, along).z, head = start.z + agent.clearance;
  return z < start.z - agent.least && z >= start.z - agent.depth &&
         !isBlockedOver(environment, place, end, start.z + agent.step, head) &&
         !isBlockedBeside(environment, end, outwards, z, head);
}

}  // namespace footfall::reference
