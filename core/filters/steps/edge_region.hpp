// The extent, along an edge of the border, of the part of a triangle that lies in half-spaces beside the edge; in
// doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/filters/steps/edge_signs.hpp"
#include "footfall/geometry.hpp"

namespace footfall::detail {

/// A linear function of the place, as factors of x, y and z and a constant; a half-space is where it is at least 0.
struct LinearFunction {
  double x = 0, y = 0, z = 0, constant = 0;
  [[nodiscard]] double at(const Vec3& p) const { return x * p.x + y * p.y + z * p.z + constant; }
  LinearFunction operator-(const LinearFunction& o) const { return {x - o.x, y - o.y, z - o.z, constant - o.constant}; }
  LinearFunction operator+(double c) const { return {x, y, z, constant + c}; }
};

/// The frame of an edge: places are relative to its begin, scaled. Everything in it is rounded; `margin` is far above
/// these errors: 2^-40 of the largest coordinate.
class EdgeFrame {
 public:
  /// Takes the edge's ends, scaled, which differ in the plan, and the largest size of a scaled coordinate.
  EdgeFrame(const Vec3& begin, const Vec3& end, double largest);

  [[nodiscard]] Vec3 local(const Vec3& p) const { return {p.x - begin_.x, p.y - begin_.y, p.z - begin_.z}; }
  [[nodiscard]] Vec3 at(double along) const;  ///< a place on the edge, scaled
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double margin() const { return margin_; }
  /// The place along the edge, from 0 at its begin to 1 at its end.
  [[nodiscard]] const LinearFunction& along() const { return along_; }
  /// The distance in the plan to the edge's line; positive on the right, where nothing is walkable.
  [[nodiscard]] const LinearFunction& outwards() const { return outwards_; }
  /// The height over the edge, straight across it.
  [[nodiscard]] const LinearFunction& above() const { return above_; }

  /// Half-spaces that hold all places within the margin of those in them.
  [[nodiscard]] std::vector<LinearFunction> widened(std::vector<LinearFunction> halfSpaces) const;
  /// The piece of the edge along which a triangle is inside all of these widened half-spaces. It is closed and holds
  /// the exact piece. Empty where the triangle is in none of them.
  [[nodiscard]] std::optional<EdgePiece> shadow(const std::array<Vec3, 3>& triangle,
                                                const std::vector<LinearFunction>& halfSpaces) const;

 private:
  Vec3 begin_, end_;
  double length_ = 0, margin_ = 0;
  LinearFunction along_, outwards_, above_;
};

}  // namespace footfall::detail
