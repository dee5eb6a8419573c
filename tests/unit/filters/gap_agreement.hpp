// Links over gaps at corners of borders against the definition.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tests/reference/gaps.hpp"
#include "tests/support/exact_borders.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/filters/gap_cases.hpp"

namespace footfall::test::corners {

using reference::BorderEdge3;
using reference::Point3;
using reference::Rational;

inline constexpr double kHeight = 2;

inline std::string gaps(double step, double gap, const std::string& more = "") {
  return minimalPipeline(kHeight) + "\nStepFilter " +
         QString("%1 %2").arg(step, 0, 'g', 17).arg(gap, 0, 'g', 17).toStdString() + "\n" + more;
}
inline NavigationMesh linked(const Soup& soup, double step, double gap, const std::string& more = "") {
  return navigationMesh(runFilters(soup.environment(), gaps(step, gap, more)));
}

/// The very ends are excluded, where only a point may be in the way.
inline Point3 nearestOn(const BorderEdge3& border, const Point3& p, const Rational& end = 0) {
  const Rational dx = border.to.x - border.from.x, dy = border.to.y - border.from.y;
  const Rational t = ((p.x - border.from.x) * dx + (p.y - border.from.y) * dy) / (dx * dx + dy * dy);
  return placeOn(border, std::clamp(t, end, Rational(1 - end)));
}

inline bool isLevel(const BorderEdge3& edge) { return edge.from.z == edge.to.z; }

struct Counts {
  std::size_t linked = 0, expected = 0;
};

/// A place of `a` from which the definition holds with a margin to spare to the nearest place of `b`, which is no less
/// than `margin` away, at an angle that is listed: there, and a little before and behind; and it holds back from `b`
/// right beside that place: of a border of which a single point is linked, nothing is.
inline bool holdsSomewhere(const Environment& environment, const BorderEdge3& a, const BorderEdge3& b, double step,
                           double gap, double margin) {
  const auto lengthOf = [](const BorderEdge3& e) {
    return std::hypot(Rational(e.to.x - e.from.x).get_d(), Rational(e.to.y - e.from.y).get_d());
  };
  const double ax = Rational(a.to.x - a.from.x).get_d(), ay = Rational(a.to.y - a.from.y).get_d();
  const double bx = Rational(b.to.x - b.from.x).get_d(), by = Rational(b.to.y - b.from.y).get_d();
  const double la = lengthOf(a), lb = lengthOf(b);
  if (la < 100 * margin || lb < 100 * margin || ax * bx + ay * by > -0.126 * la * lb) return false;
  const auto holdsAt = [&](const BorderEdge3& own, const BorderEdge3& other, const Rational& s) {
    if (s < 0 || s > 1) return false;
    const Point3 p = placeOn(own, s), q = nearestOn(other, p);
    const double x = Rational(q.x - p.x).get_d(), y = Rational(q.y - p.y).get_d(), width = std::hypot(x, y);
    const auto sineOf = [&](const BorderEdge3& e) {
      return (x * Rational(e.to.y - e.from.y).get_d() - y * Rational(e.to.x - e.from.x).get_d()) /
             (lengthOf(e) * width);
    };
    return width > margin && sineOf(own) > 0.13 && -sineOf(other) > 0.13 &&
           canStepOver(environment, own, other, p, q, step - margin, kHeight + margin, gap - margin);
  };
  const auto holdsAround = [&](const BorderEdge3& own, const BorderEdge3& other, const Rational& s) {
    const Rational beside(margin / lengthOf(own));
    return holdsAt(own, other, s) && holdsAt(own, other, s + beside) && holdsAt(own, other, s - beside);
  };
  for (const double at : {0.5, 0.9, 0.1, 0.99, 0.01, 1 - 1e-3, 1e-3, 1 - 1e-4, 1e-4}) {
    if (!holdsAround(a, b, Rational(at))) continue;
    const Point3 q = nearestOn(b, placeOn(a, Rational(at)));
    const double there = ((Rational(q.x - b.from.x).get_d()) * bx + Rational(q.y - b.from.y).get_d() * by) / (lb * lb);
    for (const double beside : {2 * margin / lb, -2 * margin / lb})
      if (holdsAround(b, a, Rational(there + beside))) return true;
  }
  return false;
}

/// Upper bound: all links over gaps are ones by the definition, on level borders from each side to the nearest place of
/// the other one. Lower bound: where the definition holds with a margin from both of two borders as they were before
/// there was any link, their triangles are connected. A link divides borders where it ends, and to a part of one the
/// nearest place may be another.
inline bool agrees(const std::shared_ptr<const Environment>& environment, double step, double gap, double margin,
                   Counts& counts) {
  const StatePtr state = runFilters(environment, gaps(step, gap));
  const ExactBorders exact(state);
  const auto fail = [&](const char* what, const Point3& p, const Point3& q) {
    qWarning("%s: %s at %.17g %.17g, %.17g %.17g", toText(*environment).c_str(), what, p.x.get_d(), p.y.get_d(),
             q.x.get_d(), q.y.get_d());
    return false;
  };
  for (const auto& gapEdges : exact.gaps) {
    ++counts.linked;
    for (const int percent : {1, 37, 61, 99}) {
      const Rational s(percent * 1000 + 13, 101000);
      const Point3 p = placeOn(gapEdges[0], s), q = placeOn(gapEdges[1], 1 - s);
      if (!canStepOver(*environment, gapEdges[0], gapEdges[1], p, q, step, kHeight, gap)) return fail("linked", p, q);
      if (!isLevel(gapEdges[0]) || !isLevel(gapEdges[1])) continue;
      for (const int side : {0, 1}) {
        const BorderEdge3 &own = gapEdges[side], &other = gapEdges[1 - side];
        const Point3 from = side == 0 ? p : q, to = nearestOn(other, from, Rational(1, 1 << 20));
        if (!canStepOver(*environment, own, other, from, to, step, kHeight, gap)) return fail("nearest", from, to);
      }
    }
  }
  const std::vector<BorderEdge3> borders = bordersOf(environment, minimalPipeline(kHeight));
  std::vector<Index> parts;
  for (const BorderEdge3& border : borders) {
    parts.push_back(exact.partOf(border));
    if (parts.back() < 0) return fail("lost", border.from, border.to);
  }
  for (std::size_t i = 0; i < borders.size(); ++i)
    for (std::size_t j = i + 1; j < borders.size(); ++j) {
      if (parts[i] == parts[j]) continue;
      if (holdsSomewhere(*environment, borders[i], borders[j], step, gap, margin) ||
          holdsSomewhere(*environment, borders[j], borders[i], step, gap, margin))
        return fail("not connected", borders[i].from, borders[j].from);
    }
  counts.expected += borders.size();
  return true;
}

}  // namespace footfall::test::corners
