// Decides where an agent steps over the gap between two borders, straight from the definition
// (docs/explanation/model.md, Gaps): slow, obvious, exact.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/steps.hpp"

namespace footfall::reference {

/// A place on an edge: from + part (to - from).
Point3 placeOn(const BorderEdge3& edge, const Rational& part);

/// The definition for a place p of one border and q of another: they are at most `gap` apart in the plan and not over
/// each other, the way from p to q leaves the walkable side of `a` and enters that of `b`, heights differ by at most
/// `step`, and over the segment pq no triangle of the environment has a point strictly between the lower height plus
/// `step` and the higher one plus `clearance`.
bool canStepOver(const Environment& environment, const BorderEdge3& a, const BorderEdge3& b, const Point3& p,
                 const Point3& q, const Rational& step, const Rational& clearance, const Rational& gap);

}  // namespace footfall::reference
