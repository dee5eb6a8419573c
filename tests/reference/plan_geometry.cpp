// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/plan_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/exact_turn.hpp"

namespace footfall::reference {
namespace {

/// The bounds of a rational given by a double: both ends of what it may be.
struct Bounds {
  double lower = 0, upper = 0;
};

/// GMP rounds towards zero, and has its own ways with what no double can hold.
Bounds boundsOf(const Rational& value) {
  constexpr double kTiny = 0x1p-200, kHuge = 0x1p200, kInfinite = std::numeric_limits<double>::infinity();
  const double near = value.get_d();
  const double size = std::fabs(near);
  if (sgn(value) == 0) return {0, 0};
  if (!(size < kHuge)) return {-kInfinite, kInfinite};
  const double beyond = size < kTiny ? kTiny : size * (1 + 0x1p-51);
  return near < 0 || (near == 0 && sgn(value) < 0) ? Bounds{-beyond, near} : Bounds{near, beyond};
}

/// A value and how far off it may be, after a handful of operations on numbers that a double has nearly.
struct Nearly {
  double value = 0, size = 0;
};
constexpr double kOff = 0x1p-47;  // share of `size`: each operand is off by 2^-52, each operation by 2^-53, and there
                                  // are few

Nearly difference(const Rational& a, const Rational& b) {
  const double p = a.get_d(), q = b.get_d();
  return {p - q, std::fabs(p) + std::fabs(q)};
}

bool isOrdinary(double size) { return size == 0 || (size > 0x1p-200 && size < 0x1p200); }

/// The sign of the double product, where it is certain; else nothing.
std::optional<int> certainTurn(const Point2& a, const Point2& b, const Point2& c) {
  const Nearly ux = difference(b.x, a.x), uy = difference(b.y, a.y);
  const Nearly vx = difference(c.x, a.x), vy = difference(c.y, a.y);
  for (const Nearly& n : {ux, uy, vx, vy})
    if (!isOrdinary(n.size)) return std::nullopt;
  const double value = ux.value * vy.value - uy.value * vx.value;
  const double most = kOff * (ux.size * vy.size + uy.size * vx.size);
  if (value > most) return 1;
  if (value < -most) return -1;
  return std::nullopt;
}

}  // namespace

Point3 toPoint(const Vec3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

Rational twiceArea(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int turn(const Point2& a, const Point2& b, const Point2& c) {
  if (const auto sign = certainTurn(a, b, c)) return *sign;
  return test::exactTurn(a.x, a.y, b.x, b.y, c.x, c.y);
}

Linear leftOf(const Point2& from, const Point2& to) {
  const Rational a = from.y - to.y, b = to.x - from.x;
  return {a, b, -a * from.x - b * from.y};
}

std::optional<Linear> planeThrough(const std::array<Point3, 3>& corners) {
  const auto& [p, q, r] = corners;
  const Rational det = twiceArea(planOf(p), planOf(q), planOf(r));
  if (det == 0) return std::nullopt;
  const Rational a = ((q.z - p.z) * (r.y - p.y) - (r.z - p.z) * (q.y - p.y)) / det;
  const Rational b = ((q.x - p.x) * (r.z - p.z) - (r.x - p.x) * (q.z - p.z)) / det;
  return Linear{a, b, p.z - a * p.x - b * p.y};
}

Polygon cleaned(const Polygon& corners) {
  Polygon result = corners;
  bool changed = true;
  while (changed && result.size() >= 3) {
    changed = false;
    for (std::size_t i = 0; i < result.size() && !changed; ++i) {
      const std::size_t n = result.size();
      if (turn(result[i], result[(i + 1) % n], result[(i + 2) % n]) == 0) {
        result.erase(result.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
        changed = true;
      }
    }
  }
  if (result.size() < 3) result.clear();
  return result;
}

Polygon planTriangle(const std::array<Point3, 3>& corners) {
  Polygon result{planOf(corners[0]), planOf(corners[1]), planOf(corners[2])};
  if (turn(result[0], result[1], result[2]) < 0) std::swap(result[1], result[2]);
  return cleaned(result);
}

Rational twiceArea(const Polygon& polygon) {
  Rational sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += twiceArea(polygon[0], polygon[i - 1], polygon[i]);
  return sum;
}

Polygon clip(const Polygon& polygon, const Linear& keep) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational vp = keep.at(p), vq = keep.at(q);
    if (vp >= 0) result.push_back(p);
    if ((vp > 0 && vq < 0) || (vp < 0 && vq > 0)) {
      const Rational s = vp / (vp - vq);
      result.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
    }
  }
  return cleaned(result);
}

PlanBox boxOf(const Polygon& polygon) {
  constexpr double kMost = std::numeric_limits<double>::max();
  PlanBox box{{kMost, kMost}, {-kMost, -kMost}};
  for (const Point2& p : polygon) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Bounds bounds = boundsOf(axis == 0 ? p.x : p.y);
      box.lower[axis] = std::min(box.lower[axis], bounds.lower);
      box.upper[axis] = std::max(box.upper[axis], bounds.upper);
    }
  }
  return box;
}

PlanBox boxOf(const Segment2& segment) { return boxOf(Polygon{segment.from, segment.to}); }

bool mayTouch(const PlanBox& a, const PlanBox& b) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (a.upper[axis] < b.lower[axis] || b.upper[axis] < a.lower[axis]) return false;
  return true;
}

bool mayTouch(const Polygon& a, const Polygon& b) {
  if (!mayTouch(boxOf(a), boxOf(b))) return false;
  const auto range = [](const Polygon& p, auto coordinate) {
    return std::minmax_element(p.begin(), p.end(),
                               [&](const Point2& u, const Point2& v) { return coordinate(u) < coordinate(v); });
  };
  if (a.empty() || b.empty()) return false;
  const auto x = [](const Point2& p) -> const Rational& { return p.x; };
  const auto y = [](const Point2& p) -> const Rational& { return p.y; };
  const auto [ax0, ax1] = range(a, x);
  const auto [bx0, bx1] = range(b, x);
  if (ax1->x < bx0->x || bx1->x < ax0->x) return false;
  const auto [ay0, ay1] = range(a, y);
  const auto [by0, by1] = range(b, y);
  return !(ay1->y < by0->y || by1->y < ay0->y);
}

namespace {

/// The sides of a line on which a polygon has corners.
struct Sides {
  bool left = false, right = false;
};
Sides sidesOf(const Polygon& polygon, const Point2& from, const Point2& to) {
  Sides sides;
  for (const Point2& p : polygon) {
    const int side = turn(from, to, p);
    sides.left = sides.left || side > 0;
    sides.right = sides.right || side < 0;
  }
  return sides;
}

/// The part on the left of a line, and, if requested, the part on its right.
Polygon leftPart(const Polygon& polygon, const Point2& from, const Point2& to, Polygon* right = nullptr) {
  const Sides sides = sidesOf(polygon, from, to);
  if (!sides.right) return polygon;
  if (!sides.left) {
    if (right != nullptr) *right = polygon;
    return {};
  }
  const Linear inside = leftOf(from, to);
  if (right != nullptr) *right = clip(polygon, {-inside.a, -inside.b, -inside.c});
  return clip(polygon, inside);
}

}  // namespace

Polygon intersection(const Polygon& a, const Polygon& b) {
  if (!mayTouch(a, b)) return {};
  Polygon result = a;
  for (std::size_t i = 0; i < b.size() && !result.empty(); ++i) result = leftPart(result, b[i], b[(i + 1) % b.size()]);
  return result;
}

Rational twiceCommonArea(const Polygon& a, const Polygon& b) { return twiceArea(intersection(a, b)); }

std::vector<Polygon> subtract(const std::vector<Polygon>& pieces, const Polygon& hole) {
  std::vector<Polygon> result;
  for (const Polygon& piece : pieces) {
    if (intersection(piece, hole).empty()) {
      result.push_back(piece);
      continue;
    }
    Polygon rest = piece;
    for (std::size_t i = 0; i < hole.size(); ++i) {
      Polygon outside;
      rest = leftPart(rest, hole[i], hole[(i + 1) % hole.size()], &outside);
      if (!outside.empty()) result.push_back(std::move(outside));
    }
  }
  return result;
}

namespace {

/// Place along `line`'s direction, 0 at its start and 1 at its end.
Rational parameter(const Segment2& line, const Point2& p) {
  return line.from.x != line.to.x ? Rational((p.x - line.from.x) / (line.to.x - line.from.x))
                                  : Rational((p.y - line.from.y) / (line.to.y - line.from.y));
}

Point2 at(const Segment2& line, const Rational& s) {
  return {line.from.x + s * (line.to.x - line.from.x), line.from.y + s * (line.to.y - line.from.y)};
}

std::optional<std::pair<Rational, Rational>> commonRange(const Segment2& a, const Segment2& b) {
  if (turn(a.from, a.to, b.from) != 0 || turn(a.from, a.to, b.to) != 0) return std::nullopt;
  Rational s = parameter(a, b.from), t = parameter(a, b.to);
  if (s > t) std::swap(s, t);
  s = std::max(s, Rational(0));
  t = std::min(t, Rational(1));
  if (s >= t) return std::nullopt;
  return std::pair{s, t};
}

}  // namespace

std::optional<Segment2> commonPart(const Segment2& a, const Segment2& b) {
  const auto range = commonRange(a, b);
  if (!range) return std::nullopt;
  return Segment2{at(a, range->first), at(a, range->second)};
}

std::vector<Segment2> uncoveredParts(const Segment2& segment, const std::vector<Segment2>& covers) {
  std::vector<std::pair<Rational, Rational>> ranges;
  for (const Segment2& c : covers)
    if (const auto range = commonRange(segment, c)) ranges.push_back(*range);
  std::sort(ranges.begin(), ranges.end());
  std::vector<Segment2> result;
  Rational done = 0;
  for (const auto& [from, to] : ranges) {
    if (from > done) result.push_back({at(segment, done), at(segment, from)});
    done = std::max(done, to);
  }
  if (done < 1) result.push_back({at(segment, done), segment.to});
  return result;
}

std::optional<Segment2> clip(const Segment2& segment, const Polygon& polygon) {
  Rational from = 0, to = 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const int atFrom = turn(p, q, segment.from), atTo = turn(p, q, segment.to);
    if (atFrom < 0 && atTo < 0) return std::nullopt;
    if (atFrom >= 0 && atTo >= 0) continue;
    const Rational a = twiceArea(p, q, segment.from), b = twiceArea(p, q, segment.to);
    const Rational s = a / (a - b);
    if (atFrom < 0)
      from = std::max(from, s);
    else
      to = std::min(to, s);
  }
  if (from >= to) return std::nullopt;
  return Segment2{at(segment, from), at(segment, to)};
}

bool passesThrough(const Segment2& segment, const Polygon& polygon) {
  const auto part = clip(segment, polygon);
  if (!part) return false;
  const Point2 middle = at(*part, Rational(1, 2));
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (turn(polygon[i], polygon[(i + 1) % polygon.size()], middle) <= 0) return false;
  return true;
}

}  // namespace footfall::reference
