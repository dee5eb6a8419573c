// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/walkable_area.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace footfall::reference {
namespace {

/// The square of the cosine with an error below 1e-60; exact where it is rational.
struct SquaredCosine {
  Rational value;
  bool exact = false;
};

SquaredCosine squaredCosine(double degrees) {
  if (degrees == 30) return {Rational(3, 4), true};
  if (degrees == 45) return {Rational(1, 2), true};
  if (degrees == 60) return {Rational(1, 4), true};
  // (1 + cos 2a) / 2 by Taylor's series, with pi to 80 digits.
  const Rational pi(
      "31415926535897932384626433832795028841971693993751058209749445923078164062862089/"
      "10000000000000000000000000000000000000000000000000000000000000000000000000000000");
  Rational x = Rational(degrees) * pi / 90;
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, 80);
  const auto rounded = [&](const Rational& v) {
    Rational result(mpz_class(v.get_num() * scale / v.get_den()), scale);
    result.canonicalize();
    return result;
  };
  x = rounded(x);
  Rational sum = 0, term = 1;
  for (int k = 1; k < 120; k += 2) {
    sum += term;
    term = rounded(-term * x * x / (k * (k + 1)));
  }
  return {(1 + sum) / 2, false};
}

}  // namespace

bool isWithinSlope(const std::array<Point3, 3>& corners, double degrees) {
  const auto plane = planeThrough(corners);
  if (!plane) return false;
  // The normal is (-a, -b, 1): cos^2 of its angle is 1 / (a^2 + b^2 + 1).
  const Rational cosine = 1 / (plane->a * plane->a + plane->b * plane->b + 1);
  const SquaredCosine limit = squaredCosine(degrees);
  const Rational difference = cosine - limit.value;
  if (!limit.exact && abs(difference) < Rational(1e-60)) throw std::runtime_error("slope too close to call");
  return difference >= 0;
}

std::array<Point3, 3> cornersOf(const Environment& environment, std::uint32_t triangle) {
  const Triangle& t = environment.triangles[triangle];
  return {toPoint(environment.vertices[t[0]]), toPoint(environment.vertices[t[1]]),
          toPoint(environment.vertices[t[2]])};
}

bool isBeside(const Environment& environment, std::uint32_t triangle, const PlanBox& box) {
  const Triangle& t = environment.triangles[triangle];
  const Vec3 &a = environment.vertices[t[0]], &b = environment.vertices[t[1]], &c = environment.vertices[t[2]];
  return std::max({a.x, b.x, c.x}) < box.lower[0] || std::min({a.x, b.x, c.x}) > box.upper[0] ||
         std::max({a.y, b.y, c.y}) < box.lower[1] || std::min({a.y, b.y, c.y}) > box.upper[1];
}

bool isOutOf(const std::array<Point3, 3>& corners, const Rational& low, const Rational& high) {
  const auto& [p, q, r] = corners;
  return (p.z <= low && q.z <= low && r.z <= low) || (p.z >= high && q.z >= high && r.z >= high);
}

std::optional<std::array<Point3, 3>> upwardCorners(const Environment& environment, std::uint32_t triangle) {
  std::array<Point3, 3> corners = cornersOf(environment, triangle);
  Rational area = twiceArea(planOf(corners[0]), planOf(corners[1]), planOf(corners[2]));
  if (area < 0 && environment.bothSides) {
    std::swap(corners[1], corners[2]);
    area = -area;
  }
  if (area <= 0) return std::nullopt;
  return corners;
}

bool isDegenerate(const std::array<Point3, 3>& corners) {
  const auto& [p, q, r] = corners;
  const auto crossZ = [](const Rational& ux, const Rational& uy, const Rational& vx, const Rational& vy) {
    return Rational(ux * vy - uy * vx);
  };
  const Rational ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z, vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  return crossZ(ux, uy, vx, vy) == 0 && crossZ(uy, uz, vy, vz) == 0 && crossZ(uz, ux, vz, vx) == 0;
}

Polygon blockedArea(const std::array<Point3, 3>& obstacle, const Linear& floor, const Rational& height) {
  const auto plane = planeThrough(obstacle);
  if (!plane) return {};
  const Linear above{plane->a - floor.a, plane->b - floor.b, plane->c - floor.c};
  if (above.a == 0 && above.b == 0 && (above.c <= 0 || above.c >= height)) return {};
  const Linear below{-above.a, -above.b, height - above.c};
  return clip(clip(planTriangle(obstacle), above), below);
}

std::optional<Segment2> blockedTrace(const std::array<Point3, 3>& obstacle, const Linear& floor,
                                     const Rational& height) {
  if (planeThrough(obstacle) || isDegenerate(obstacle)) return std::nullopt;
  // Clip the triangle in space, with heights above the floor in place of z, to 0 <= z <= height.
  std::vector<Point3> points;
  for (const Point3& p : obstacle) points.push_back({p.x, p.y, p.z - floor.at(planOf(p))});
  for (const bool ceiling : {false, true}) {
    const auto value = [&](const Point3& p) { return ceiling ? Rational(height - p.z) : p.z; };
    std::vector<Point3> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point3 &p = points[i], &q = points[(i + 1) % points.size()];
      const Rational vp = value(p), vq = value(q);
      if (vp >= 0) kept.push_back(p);
      if ((vp > 0 && vq < 0) || (vp < 0 && vq > 0)) {
        const Rational s = vp / (vp - vq);
        kept.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)});
      }
    }
    points = std::move(kept);
  }
  // The polygon must reach into the open interval, not only touch its ends.
  if (std::all_of(points.begin(), points.end(), [](const Point3& p) { return p.z == 0; })) return std::nullopt;
  if (std::all_of(points.begin(), points.end(), [&](const Point3& p) { return p.z == height; })) return std::nullopt;
  const auto before = [](const Point3& p, const Point3& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
  const auto [first, last] = std::minmax_element(points.begin(), points.end(), before);
  if (planOf(*first) == planOf(*last)) return std::nullopt;
  return Segment2{planOf(*first), planOf(*last)};
}

bool isFree(const Environment& environment, std::uint32_t floor, const Point2& place, double clearance) {
  const Linear plane = *planeThrough(cornersOf(environment, floor));
  const PlanBox box = boxOf(Polygon{place});
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    if (t == floor || isBeside(environment, t, box)) continue;
    const auto corners = cornersOf(environment, t);
    const Polygon triangle = planTriangle(corners);
    bool covers = !triangle.empty();
    for (std::size_t k = 0; k < 3 && covers; ++k) covers = turn(triangle[k], triangle[(k + 1) % 3], place) >= 0;
    if (!covers) continue;
    const Rational height = planeThrough(corners)->at(place) - plane.at(place);
    if (height > 0 && height < clearance) return false;
  }
  return true;
}

WalkableArea computeWalkableArea(const Environment& environment, const AgentLimits& agent) {
  WalkableArea area;
  const auto count = static_cast<std::uint32_t>(environment.triangles.size());
  for (std::uint32_t t = 0; t < count; ++t) {
    if (!environment.obstacleOnly.empty() && environment.obstacleOnly[t] != 0) continue;  // rejected from the start
    const auto corners = upwardCorners(environment, t);
    if (!corners || (agent.slope && !isWithinSlope(*corners, *agent.slope))) continue;
    const Linear plane = *planeThrough(*corners);
    auto region =
        std::find_if(area.regions.begin(), area.regions.end(), [&](const Region& r) { return r.plane == plane; });
    if (region == area.regions.end()) region = area.regions.insert(area.regions.end(), Region{plane, {}, {}, {}});
    // Parts that earlier floors of the plane cover exist already.
    std::vector<Polygon> pieces{planTriangle(*corners)};
    for (const std::uint32_t f : region->floors) pieces = subtract(pieces, planTriangle(cornersOf(environment, f)));
    region->floors.push_back(t);
    region->cells.insert(region->cells.end(), pieces.begin(), pieces.end());
  }
  if (!agent.clearance) return area;
  const Rational height(*agent.clearance);
  for (Region& region : area.regions) {
    for (std::uint32_t t = 0; t < count; ++t) {
      const auto corners = cornersOf(environment, t);
      const Polygon blocked = blockedArea(corners, region.plane, height);
      if (!blocked.empty()) region.cells = subtract(region.cells, blocked);
      if (const auto trace = blockedTrace(corners, region.plane, height)) region.traces.push_back(*trace);
    }
    // Walls cut cells, so that each cell is connected in itself.
    for (const Segment2& trace : region.traces) {
      std::vector<Polygon> cut;
      for (const Polygon& cell : region.cells) {
        if (!passesThrough(trace, cell)) {
          cut.push_back(cell);
          continue;
        }
        const Linear left = leftOf(trace.from, trace.to);
        cut.push_back(clip(cell, left));
        cut.push_back(clip(cell, {-left.a, -left.b, -left.c}));
      }
      region.cells = std::move(cut);
    }
  }
  return area;
}

namespace {

double lengthInSpace(const Segment2& s, const Linear& plane) {
  const Rational dx = s.to.x - s.from.x, dy = s.to.y - s.from.y, dz = plane.at(s.to) - plane.at(s.from);
  return std::sqrt(Rational(dx * dx + dy * dy + dz * dz).get_d());
}

void findMeetings(const Region& r, const Region& s, const Polygon& a, const Polygon& b, Meeting& meeting) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const auto common = commonPart({a[i], a[(i + 1) % a.size()]}, {b[j], b[(j + 1) % b.size()]});
      if (!common || r.plane.at(common->from) != s.plane.at(common->from) ||
          r.plane.at(common->to) != s.plane.at(common->to))
        continue;
      // Both floors are equally high on the line itself, so a wall's trace is the same on either.
      for (Segment2& part : uncoveredParts(*common, r.traces)) {
        meeting.freeLength += lengthInSpace(part, r.plane);
        meeting.free.push_back(std::move(part));
      }
      meeting.blockedLength += lengthInSpace(*common, r.plane);
    }
  }
  meeting.blockedLength -= meeting.freeLength;
}

}  // namespace

std::vector<Meeting> findMeetings(const WalkableArea& area) {
  std::vector<std::pair<const Region*, const Polygon*>> cells;
  std::vector<PlanBox> boxes;
  for (const Region& region : area.regions)
    for (const Polygon& cell : region.cells) {
      cells.emplace_back(&region, &cell);
      boxes.push_back(boxOf(cell));
    }
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = i + 1; j < cells.size(); ++j) {
      if (!mayTouch(boxes[i], boxes[j])) continue;
      Meeting meeting{i, j, {}, 0, 0};
      findMeetings(*cells[i].first, *cells[j].first, *cells[i].second, *cells[j].second, meeting);
      if (!meeting.free.empty() || meeting.blockedLength > 0) meetings.push_back(std::move(meeting));
    }
  }
  return meetings;
}

std::vector<std::size_t> connectedParts(const WalkableArea& area, const std::vector<Meeting>& meetings) {
  std::size_t count = 0;
  for (const Region& region : area.regions) count += region.cells.size();
  std::vector<std::size_t> parts(count);
  std::iota(parts.begin(), parts.end(), 0);
  for (const Meeting& m : meetings) {
    if (m.free.empty()) continue;
    const std::size_t from = std::max(parts[m.first], parts[m.second]);
    const std::size_t to = std::min(parts[m.first], parts[m.second]);
    std::replace(parts.begin(), parts.end(), from, to);
  }
  std::vector<std::size_t> numbers = parts;
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (std::size_t& p : parts)
    p = static_cast<std::size_t>(std::lower_bound(numbers.begin(), numbers.end(), p) - numbers.begin());
  return parts;
}

std::size_t countParts(const std::vector<std::size_t>& parts) {
  return parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1;
}

Rational twiceArea(const Region& region) {
  Rational sum = 0;
  for (const Polygon& cell : region.cells) sum += twiceArea(cell);
  return sum;
}

Rational twiceArea(const WalkableArea& area) {
  Rational sum = 0;
  for (const Region& region : area.regions) sum += twiceArea(region);
  return sum;
}

}  // namespace footfall::reference
