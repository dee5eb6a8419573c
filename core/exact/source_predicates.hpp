// Exact decisions on single source triangles, for any finite doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/base/index_and_box.hpp"
#include "core/exact/error_double.hpp"

namespace footfall::detail {

/// True when the three positions are collinear or equal (cases 2 to 4 of thesis 4.4.2).
bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c);

/// Sign of the z component of (b - a) x (c - a): +1 faces up, 0 vertical or degenerate, -1 faces down.
int facing(const Vec3& a, const Vec3& b, const Vec3& c);

/// True when a, b, c (counter-clockwise) faces up and the angle between its normal and +Z is at most `degrees`
/// (0 < degrees < 90), exactly. Degenerate triangles are never within. `beyondDoubles` (may be null) is set to true
/// when doubles could not decide.
bool isWithinSlope(const Vec3& a, const Vec3& b, const Vec3& c, double degrees, bool* beyondDoubles = nullptr);

/// The limit that SlopeFilter compares with, in degrees: the maximum slope and its tolerance, summed and rounded as
/// doubles are, and below 90. It never falls when one of them grows.
double slopeLimit(double maxSlope, double tolerance);

/// The angle of isWithinSlope(), for many triangles whose normals are computed already.
class SlopeLimit {
 public:
  explicit SlopeLimit(double degrees);

  /// +1: a normal that faces up is within the angle, -1: it is not. The components may have any common scale; `sign` is
  /// the rule for their signs.
  [[nodiscard]] MaybeSign compare(const std::array<ErrorDouble, 3>& normal, const SignRule& sign) const;

 private:
  int quarters_;         ///< cos^2 of the angle where it is rational, as numerator over 4; 0 elsewhere
  ErrorDouble squared_;  ///< cos^2 of the angle
};

}  // namespace footfall::detail
