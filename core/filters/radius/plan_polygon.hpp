// Convex polygons of the plan with corners in units of margins.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/filters/radius/margin_surface.hpp"

namespace footfall::detail {

inline double roundToUnit(double x) { return std::nearbyint(x / MarginSurface::kUnit) * MarginSurface::kUnit; }
inline PlanVector roundToUnit(const PlanVector& p) { return {roundToUnit(p.x), roundToUnit(p.y)}; }

/// The parts of polygons in a rectangle around a surface. Cut polygons have corners in units again.
class ClipBox {
 public:
  explicit ClipBox(const MarginSurface& surface);

  [[nodiscard]] double diagonal() const { return length({upper_[0] - lower_[0], upper_[1] - lower_[1]}); }
  [[nodiscard]] bool holds(const PlanVector& p) const {
    return lower_[0] <= p.x && p.x <= upper_[0] && lower_[1] <= p.y && p.y <= upper_[1];
  }
  /// Returns whether something was cut off.
  bool clip(std::vector<PlanVector>& corners) const;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> lower_{kInfinity, kInfinity}, upper_{-kInfinity, -kInfinity};
};

/// The convex hull of places in units, counter-clockwise, exactly: rounding can turn a corner the wrong way. Quick for
/// those that are the corners of one already, in that order.
std::vector<PlanVector> hullOf(std::vector<PlanVector> places);

}  // namespace footfall::detail
