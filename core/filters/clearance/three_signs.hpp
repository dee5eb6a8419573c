// The signs of a number at each corner of a triangle, as bits that are decided and tested together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/double2.hpp"
#include "footfall/geometry.hpp"

namespace footfall::detail {

/// A number at each of three corners.
struct Three {
  Double2 first;  ///< values at the corners 0 and 1
  double last;
};

/// Bit j of one or the other for the number j; of none where it is 0.
struct ThreeSigns {
  unsigned positive = 0, negative = 0;

  void set(unsigned corner, int sign) {
    positive |= (sign > 0 ? 1U : 0U) << corner;
    negative |= (sign < 0 ? 1U : 0U) << corner;
  }

  /// +1, 0 or -1 of each corner.
  [[nodiscard]] const std::array<std::int8_t, 3>& each() const { return kEach[negative << 3U | positive]; }

  /// The signs of `numbers - bound`, for numbers without rounding.
  static ThreeSigns above(const Three& numbers, double bound) {
    return {maskOf(numbers.first > bound) | (numbers.last > bound ? 4U : 0U),
            maskOf(numbers.first < bound) | (numbers.last < bound ? 4U : 0U)};
  }

 private:
  static constexpr std::array<std::array<std::int8_t, 3>, 64> kEach = [] {
    std::array<std::array<std::int8_t, 3>, 64> each{};
    for (int bits = 0; bits < 64; ++bits)
      for (int j = 0; j < 3; ++j) each[bits][j] = static_cast<std::int8_t>((bits >> j & 1) - (bits >> (j + 3) & 1));
    return each;
  }();
};

/// True when at least two bits are set.
[[nodiscard]] constexpr bool hasTwo(unsigned bits) { return (bits & (bits - 1)) != 0; }

/// The corners of a triangle in the plan.
struct PlanCorners {
  Three x, y;

  PlanCorners(const Vec3& p, const Vec3& q, const Vec3& r) : x{Double2{p.x, q.x}, r.x}, y{Double2{p.y, q.y}, r.y} {}
};

/// The edges of a triangle in the plan (corner k to k + 1) as lines a x + b y + c, which are positive to the left.
/// Where Grid::hasExactOrientations() of all places, with coordinates below 2^w in units of the grid, every step is
/// below 2^(2 w + 3) and so without a rounding.
class PlanEdges {
 public:
  PlanEdges() = default;
  PlanEdges(const Vec3& p, const Vec3& q, const Vec3& r) : lines_{Line(p, q), Line(q, r), Line(r, p)} {}

  /// The sides of an edge on which the corners lie.
  [[nodiscard]] ThreeSigns sidesOf(int edge, const PlanCorners& corners) const {
    const auto& [a, b, c] = lines_[static_cast<std::size_t>(edge)];
    return ThreeSigns::above(
        {a * corners.x.first + b * corners.y.first + c, a * corners.x.last + b * corners.y.last + c}, 0);
  }

 private:
  struct Line {
    double a = 0, b = 0, c = 0;
    Line() = default;
    Line(const Vec3& p, const Vec3& q) : a(p.y - q.y), b(q.x - p.x), c(p.x * q.y - q.x * p.y) {}
  };
  std::array<Line, 3> lines_;
};

/// The sides of each edge of one triangle on which the corners of another one lie.
using EdgeSides = std::array<ThreeSigns, 3>;

}  // namespace footfall::detail
