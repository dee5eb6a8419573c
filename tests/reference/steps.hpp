// Decides where an agent steps from one border to another, straight from the definition (docs/explanation/model.md,
// Links): slow, obvious, exact.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/plan_geometry.hpp"

namespace footfall::reference {

/// An edge of the border, with the walkable area on its left.
struct BorderEdge3 {
  Point3 from, to;
};

/// The stretch of the plan on which two borders lie over each other, walkable areas on either side; nothing where that
/// has no length.
std::optional<Segment2> sharedStretch(const BorderEdge3& a, const BorderEdge3& b);

/// The definition for one place of the plan that lies on both borders: their heights differ by at most `step`, and no
/// triangle of the environment has a point straight over it that is strictly between the lower height plus `step` and
/// the higher one plus `clearance`.
bool canStepAt(const Environment& environment, const BorderEdge3& a, const BorderEdge3& b, const Point2& place,
               const Rational& step, const Rational& clearance);

}  // namespace footfall::reference
