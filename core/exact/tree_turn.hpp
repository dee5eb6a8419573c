// The frame in the plan of a tree over a level whose edges do not follow the axes.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes along the axes around the triangles of a level that somebody turned are far larger than the triangles, so a
// query finds several times as many. Boxes along the level's own main direction fit as before. A turned coordinate is a
// sum of two products that is off by less than the margin of its box, so boxes of triangles that meet always overlap.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/index_and_box.hpp"
#include "footfall/geometry.hpp"

namespace footfall::detail {

class TreeTurn {
 public:
  /// The new first axis is the direction (x, y), of about unit length.
  TreeTurn(double x, double y) : x_(x), y_(y) {}

  /// The box in the turned frame around places; heights are those of `box`.
  [[nodiscard]] Box around(std::span<const Vec3> places, const Box& box) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::array<double, 2> lower{kInfinity, kInfinity}, upper{-kInfinity, -kInfinity};
    double size = 0;
    for (const Vec3& p : places) {
      const std::array<double, 2> turned{x_ * p.x + y_ * p.y, x_ * p.y - y_ * p.x};
      for (std::size_t k = 0; k < 2; ++k) {
        lower[k] = std::min(lower[k], turned[k]);
        upper[k] = std::max(upper[k], turned[k]);
      }
      size = std::max(size, std::fabs(p.x) + std::fabs(p.y));
    }
    if (!(size < kLargest)) return {{-kInfinity, -kInfinity, box.lower[2]}, {kInfinity, kInfinity, box.upper[2]}};
    const double margin = size * kRounding + std::numeric_limits<double>::min();
    return {{lower[0] - margin, lower[1] - margin, box.lower[2]}, {upper[0] + margin, upper[1] + margin, box.upper[2]}};
  }

  /// The box in the turned frame around a box.
  [[nodiscard]] Box around(const Box& box) const {
    const auto& [lower, upper] = box;
    return around(std::array{Vec3{lower[0], lower[1], 0}, Vec3{upper[0], lower[1], 0}, Vec3{lower[0], upper[1], 0},
                             Vec3{upper[0], upper[1], 0}},
                  box);
  }

 private:
  static constexpr double kRounding = 0x1p-50;  ///< several times what the products and their sum lose
  static constexpr double kLargest = 0x1p1000;  ///< nothing overflows below

  double x_, y_;
};

}  // namespace footfall::detail
