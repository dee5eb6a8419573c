// A place in the plan that is on no line: exact questions about what lies above and below it always have an answer.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Somebody who points at a place means the area around it, also where the point itself lies on an edge of a floor or
// below the edge of an obstacle. So the place is taken to be moved from its coordinates by an infinitely small step,
// and from there, at right angles, by another one that is infinitely smaller still (simulation of simplicity;
// Edelsbrunner and Muecke 1990). Every comparison looks at the coordinates first, and where they say "equal" at the
// first step, then at the second; two lines that are different are never both along both.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// Coordinates in environment units, Z up.
using ExactPoint = std::array<mpq_class, 3>;

ExactPoint exactPoint(const Vec3& place);

/// A number that depends on where in the plan one stands: at the coordinates, and how it grows along the two steps.
struct GenericNumber {
  mpq_class value, firstStep, secondStep;

  [[nodiscard]] int sign() const;
  friend GenericNumber operator-(const GenericNumber& a, const GenericNumber& b) {
    return {a.value - b.value, a.firstStep - b.firstStep, a.secondStep - b.secondStep};
  }
  friend GenericNumber operator-(const GenericNumber& a, const mpq_class& b) {
    return {a.value - b, a.firstStep, a.secondStep};
  }
};

class GenericPlace {
 public:
  /// The place (x, y), moved towards (towardsX, towardsY); if these are the same place, along x.
  GenericPlace(mpq_class x, mpq_class y, const mpq_class& towardsX, const mpq_class& towardsY);

  [[nodiscard]] const mpq_class& x() const { return x_; }
  [[nodiscard]] const mpq_class& y() const { return y_; }

  /// +1 left of the line from a to b in the plan, -1 right of it; 0 only when a and b are above each other.
  [[nodiscard]] int side(const ExactPoint& a, const ExactPoint& b) const;
  /// True when it is inside a triangle in the plan, whichever way that faces; never true for a vertical one.
  [[nodiscard]] bool isInside(const std::array<ExactPoint, 3>& corners) const;
  /// The height of the plane through three points here; empty when it is vertical or they are collinear.
  [[nodiscard]] std::optional<GenericNumber> heightOf(const std::array<ExactPoint, 3>& corners) const;

 private:
  mpq_class x_, y_, stepX_, stepY_;
};

}  // namespace footfall::detail
