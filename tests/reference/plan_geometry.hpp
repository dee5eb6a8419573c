// Exact plane geometry in rationals, slow and obvious: convex polygons, half-planes, segments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::reference {

using Rational = mpq_class;

struct Point2 {
  Rational x, y;
  bool operator==(const Point2& o) const { return x == o.x && y == o.y; }
};

struct Point3 {
  Rational x, y, z;
  bool operator==(const Point3& o) const { return x == o.x && y == o.y && z == o.z; }
  bool operator<(const Point3& o) const { return x != o.x ? x < o.x : y != o.y ? y < o.y : z < o.z; }
};

Point3 toPoint(const Vec3& v);
inline Point2 planOf(const Point3& p) { return {p.x, p.y}; }

/// a x + b y + c, a linear function over the plan. As a plane: z = a x + b y + c.
struct Linear {
  Rational a, b, c;
  [[nodiscard]] Rational at(const Point2& p) const { return a * p.x + b * p.y + c; }
  bool operator==(const Linear& o) const { return a == o.a && b == o.b && c == o.c; }
};

/// The plane through three points, or nothing when it is vertical or they are collinear.
std::optional<Linear> planeThrough(const std::array<Point3, 3>& corners);

/// Positive left of the line from `from` to `to`.
Linear leftOf(const Point2& from, const Point2& to);

/// Twice the signed area of a triangle in the plan.
Rational twiceArea(const Point2& a, const Point2& b, const Point2& c);

/// Its sign: 1, 0 or -1. Exact; doubles decide where they can, as rationals cost a hundred times as much.
int turn(const Point2& a, const Point2& b, const Point2& c);

/// Convex, counter-clockwise, no three corners in a row collinear; empty when it has no area.
using Polygon = std::vector<Point2>;

/// Drops repeated and collinear corners of a convex polygon; empty when nothing with an area is left.
Polygon cleaned(const Polygon& corners);
/// The triangle counter-clockwise, whatever way it was given; empty without area.
Polygon planTriangle(const std::array<Point3, 3>& corners);
Rational twiceArea(const Polygon& polygon);
/// The part of the polygon where `keep` is at least 0.
Polygon clip(const Polygon& polygon, const Linear& keep);
Polygon intersection(const Polygon& a, const Polygon& b);
/// Twice the area that two polygons have in common.
Rational twiceCommonArea(const Polygon& a, const Polygon& b);
/// The remainder of disjoint pieces without `hole`, as disjoint convex pieces.
std::vector<Polygon> subtract(const std::vector<Polygon>& pieces, const Polygon& hole);
bool mayTouch(const Polygon& a, const Polygon& b);

struct Segment2 {
  Point2 from, to;
};

/// A box in the plan, in doubles and a little too large. Algorithms over many pairs skip pairs with separate boxes.
struct PlanBox {
  std::array<double, 2> lower, upper;
};
PlanBox boxOf(const Polygon& polygon);
PlanBox boxOf(const Segment2& segment);
bool mayTouch(const PlanBox& a, const PlanBox& b);

/// The part that two segments have in common, when it has a length.
std::optional<Segment2> commonPart(const Segment2& a, const Segment2& b);
/// The parts of `segment` that none of `covers` covers, in order along it.
std::vector<Segment2> uncoveredParts(const Segment2& segment, const std::vector<Segment2>& covers);
/// The part of a segment inside a convex polygon (boundary included), when it has a length.
std::optional<Segment2> clip(const Segment2& segment, const Polygon& polygon);
/// True when a part of the segment with a length lies in the open inside of the polygon.
bool passesThrough(const Segment2& segment, const Polygon& polygon);

}  // namespace footfall::reference
