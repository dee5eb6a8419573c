// The strip of the plan that ways over a gap cover; leaves out triangles that lie beside, below or above it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace footfall::detail {

/// The convex hull of four places of a frame.
class GapStrip {
 public:
  /// Coordinates along a frame and across it.
  using Place = std::array<double, 2>;

  /// `margin` is the distance by which a triangle must lie apart.
  GapStrip(const std::array<Place, 4>& corners, double margin) : corners_(corners), margin_(margin) {}

  /// Returns whether the line through one side of a triangle has the strip beyond it by more than the margin. The
  /// triangle may be a line in the plan and may face either way. Coordinates that are not finite give false.
  [[nodiscard]] bool isBeyondSide(const std::array<Place, 3>& triangle) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Place &p = triangle[k], &q = triangle[(k + 1) % 3], &apex = triangle[(k + 2) % 3];
      const double x = q[0] - p[0], y = q[1] - p[1];
      const auto side = [&](const Place& c) { return x * (c[1] - p[1]) - y * (c[0] - p[0]); };
      const std::array<double, 4> sides{side(corners_[0]), side(corners_[1]), side(corners_[2]), side(corners_[3])};
      const double bound = margin_ * (std::fabs(x) + std::fabs(y)), top = side(apex);
      const double least = std::min(top, 0.0) - bound, most = std::max(top, 0.0) + bound;
      if (sides[0] < least && sides[1] < least && sides[2] < least && sides[3] < least) return true;
      if (sides[0] > most && sides[1] > most && sides[2] > most && sides[3] > most) return true;
    }
    return false;
  }

  /// A room over the strip: the bounds of its height at its first and third corner, and at its second and fourth.
  struct Heights {
    std::array<double, 2> lowest{}, highest{};
  };
  /// Returns whether the plane of a triangle has the room on one side of it by more than the margin.
  [[nodiscard]] bool isOffPlane(const std::array<Place, 3>& triangle, const std::array<double, 3>& z,
                                const Heights& room) const {
    const double ux = triangle[1][0] - triangle[0][0], uy = triangle[1][1] - triangle[0][1], uz = z[1] - z[0];
    const double vx = triangle[2][0] - triangle[0][0], vy = triangle[2][1] - triangle[0][1], vz = z[2] - z[0];
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double error =
        kRounding * (std::fabs(ux) + std::fabs(uy) + std::fabs(uz)) * (std::fabs(vx) + std::fabs(vy) + std::fabs(vz));
    const double bound = margin_ * (std::fabs(nx) + std::fabs(ny) + std::fabs(nz));
    bool isAbove = true, isBelow = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = corners_[i][0] - triangle[0][0], y = corners_[i][1] - triangle[0][1];
      for (const double height : {room.lowest[i % 2], room.highest[i % 2]}) {
        const double up = height - z[0], side = nx * x + ny * y + nz * up;
        const double least = bound + error * (std::fabs(x) + std::fabs(y) + std::fabs(up));
        isAbove = isAbove && side > least;
        isBelow = isBelow && side < -least;
      }
    }
    return isAbove || isBelow;
  }

 private:
  /// A component of the normal is off by 2^-50 of the product of both sides, and the product of the normal and a place
  /// by as much of all three.
  static constexpr double kRounding = 0x1p-48;

  std::array<Place, 4> corners_;
  double margin_;
};

}  // namespace footfall::detail
