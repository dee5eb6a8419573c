// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/plan_geometry.hpp"

#include <algorithm>

namespace footfall::reference {

Point3 toPoint(const Vec3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

Rational twiceArea(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
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
      if (twiceArea(result[i], result[(i + 1) % n], result[(i + 2) % n]) == 0) {
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
  if (twiceArea(result[0], result[1], result[2]) < 0) std::swap(result[1], result[2]);
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

bool mayTouch(const Polygon& a, const Polygon& b) {
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

Polygon intersection(const Polygon& a, const Polygon& b) {
  if (!mayTouch(a, b)) return {};
  Polygon result = a;
  for (std::size_t i = 0; i < b.size() && !result.empty(); ++i)
    result = clip(result, leftOf(b[i], b[(i + 1) % b.size()]));
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
      const Linear inside = leftOf(hole[i], hole[(i + 1) % hole.size()]);
      Polygon outside = clip(rest, {-inside.a, -inside.b, -inside.c});
      if (!outside.empty()) result.push_back(std::move(outside));
      rest = clip(rest, inside);
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
  if (twiceArea(a.from, a.to, b.from) != 0 || twiceArea(a.from, a.to, b.to) != 0) return std::nullopt;
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
    const Linear inside = leftOf(polygon[i], polygon[(i + 1) % polygon.size()]);
    const Rational a = inside.at(segment.from), b = inside.at(segment.to);
    if (a < 0 && b < 0) return std::nullopt;
    if (a >= 0 && b >= 0) continue;
    const Rational s = a / (a - b);
    if (a < 0)
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
    if (leftOf(polygon[i], polygon[(i + 1) % polygon.size()]).at(middle) <= 0) return false;
  return true;
}

}  // namespace footfall::reference
