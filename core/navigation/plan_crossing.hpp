// The crossing of two lines in the plan, with small relative errors however nearly parallel they are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "footfall/environment.hpp"

namespace footfall::detail {

/// The place on the segment from c (0) to d (1) at which the line through a and b crosses it, in the plan. c and d must
/// lie on different sides of the line, or one of them on it (not both).
///
/// It is o(c) / (o(c) - o(d)) with the areas o(p) of the triangles (a, b, p). These have opposite signs, so that
/// nothing cancels once each is known with a small relative error; where doubles do not give that, the quotient is
/// computed with rationals. So the result is off by a few units in the last place, and in [0, 1].
double crossingParameter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The point at this parameter; 0 and 1 give c and d themselves, anything between lies in their box.
Vec3 pointBetween(const Vec3& c, const Vec3& d, double parameter);

}  // namespace footfall::detail
